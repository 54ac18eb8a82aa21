#!/usr/bin/python3
"""Free surface of the last state of two-dimensional runs by four methods: the table "In runs" of docs/free-surface.md.

    surface_methods.py RESULTS.h5 ...

For each run and method the mean less the level of the water's volume, in particle spacings, and the standard deviation
along the channel, mm. Wendland's kernel only.
"""
import pathlib
import sys
import tomllib

import h5py
import numpy

METHODS = ("divergence 1", "divergence 1.4", "fraction 0.5", "depth sum")
STEP = 0.02  # of the scan from above, in particle spacings; the crossing lies between two steps, linearly


def fraction_shape(q):
    return 7 / (4 * numpy.pi) * (1 - q / 2) ** 4 * (2 * q + 1)


def divergence_shape(q):
    """-q dW/dq"""
    return 7 / (4 * numpy.pi) * 5 * q**2 * (1 - q / 2) ** 3


def depth_shape(q):
    """The kernel of one dimension."""
    return 5 / 8 * (1 - q / 2) ** 3 * (1.5 * q + 1)


def crossing(heights, sums, threshold):
    """Highest place at which the sums, given from above, reach the threshold."""
    reached = numpy.flatnonzero(sums >= threshold)
    if not reached.size:
        return numpy.nan
    i = reached[0]
    return heights[i] + (heights[i - 1] - heights[i]) * (sums[i] - threshold) / (sums[i] - sums[i - 1])


class State:
    def __init__(self, path):
        with h5py.File(path) as file:
            case = tomllib.loads(file["case/text"][()].decode())
            if file.attrs["dimension"] != 2 or case["numerics"]["kernel"] != "wendland-c2":
                raise SystemExit(f"{path}: expected a two-dimensional run with kernel = \"wendland-c2\"")
            self.x, self.z = file["state/position_x"][()], file["state/position_z"][()]
            density = case["fluid"]["density"] * (1 + file["state/density_deviation"][()])
            self.volume = file["state/mass"][()] / density
        self.length, self.spacing = case["channel"]["length"], case["numerics"]["spacing"]
        self.h = case["numerics"]["smoothing_ratio"] * self.spacing

    def surfaces(self, place):
        """Elevation at a place by each method."""
        distance = numpy.abs((self.x - place + self.length / 2) % self.length - self.length / 2)
        near = distance < 2 * self.h
        distance, z, volume = distance[near], self.z[near], self.volume[near]
        depth = numpy.sum(volume * depth_shape(distance / self.h)) / self.h
        heights = numpy.arange(z.max() + 2 * self.h, z.max() - 6 * self.spacing, -STEP * self.spacing)
        q = numpy.minimum(2, numpy.hypot(distance, heights[:, None] - z) / self.h)
        divergence, fraction = ((volume * shape(q)).sum(axis=1) / self.h**2 for shape in (divergence_shape, fraction_shape))
        return (crossing(heights, divergence, 1.0), crossing(heights, divergence, 1.4), crossing(heights, fraction, 0.5), depth)

    def row(self):
        places = numpy.arange(0, self.length, self.spacing / 2)
        found = numpy.array([self.surfaces(place) for place in places])
        bias = (found.mean(axis=0) - self.volume.sum() / self.length) / self.spacing
        return [cell for one, scatter in zip(bias, 1e3 * found.std(axis=0)) for cell in (f"{one:+.2f}", f"{scatter:.3f}")]


def main():
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    print("| run | " + " | | ".join(METHODS) + " | |\n" + "|---" * (1 + 2 * len(METHODS)) + "|")
    print("| " + " | bias | mm" * len(METHODS) + " |")
    for path in map(pathlib.Path, sys.argv[1:]):
        state = State(path)
        print(f"| {path.parent.name}, {1e3 * state.spacing:g} mm | " + " | ".join(state.row()) + " |")


if __name__ == "__main__":
    main()
