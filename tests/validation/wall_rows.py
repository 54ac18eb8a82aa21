#!/usr/bin/env python3
"""Why the wall layer of a plane bed is five rows high (docs/theory.md, section 8).

  tests/validation/wall_rows.py     prints the error of the mean velocity for layers of 1 to 6 rows; seconds

The steady flow of rows of particles in a plane, with the pair viscosity of the scheme (Morris' form, mean of the mixing lengths, kernel
Wendland C2), the velocity gradient corrected for the kernel's support, and the wall layer of src/turbulence/wall_layer.cpp: a model of a
run whose particles stay in their rows. Errors in % of the mean velocity of the law of the wall, over k_s/h of 0.002, 0.01, 0.05 and 0.3.
"""

import numpy

KAPPA = 0.41
CLOSURES = {"nezu-rodi": lambda z: KAPPA * z * numpy.sqrt(numpy.maximum(1 - z, 0)), "ramp": lambda z: numpy.minimum(KAPPA * z, 0.09)}


class WallLayer:
    """Lengths over the depth, velocities over u_*."""

    def __init__(self, height, drag_top, zero_height, closure):
        self.height, self.zero_height, self.closure = height, zero_height, closure
        self.z = numpy.concatenate([[0], numpy.geomspace(1e-3 * zero_height, 0.99999, 20000)])
        gradient = numpy.sqrt(1 - self.z) / numpy.concatenate([[KAPPA * zero_height], self.above(self.z[1:])])
        integral = lambda f: numpy.concatenate([[0], numpy.cumsum(0.5 * (f[1:] + f[:-1]) * numpy.diff(self.z))])
        self.u = integral(gradient)
        flow = integral(self.u)
        self.mean_velocity = flow[-1]
        self.top, self.slope = numpy.interp(height, self.z, self.u), height * numpy.interp(height, self.z, gradient)
        self.bend = 30 * ((self.top - numpy.interp(height, self.z, flow) / height) / self.slope - 0.5)
        self.inside = numpy.linspace(0, height, 4001)
        self.drag_top = drag_top
        squares = self.velocity(self.inside) ** 2 * self.drag_shape(self.inside)
        drag = numpy.concatenate([[0], numpy.cumsum(0.5 * (squares[1:] + squares[:-1]) * numpy.diff(self.inside))])
        self.coefficient = 1 / drag[-1]
        t = 1 - self.inside[1:] / height
        steepness = self.slope * (1 - t) * (1 + t * (2 + self.bend * t)) / height
        at_top = self.above(height)
        self.lengths = numpy.append(at_top, numpy.minimum(numpy.sqrt(numpy.maximum(drag[1:] / drag[-1] - self.inside[1:], 0)) / steepness, at_top))

    def drag_shape(self, z):
        return numpy.clip(1 - z / self.drag_top, 0, 1)

    def row_drag(self, z, dz):
        parts = z[:, None] + ((numpy.arange(40) + 0.5) / 40 - 0.5) * dz
        return self.coefficient * self.drag_shape(parts).mean(axis=1)

    def above(self, z):
        return self.closure(z) * (1 + self.zero_height / z)

    def velocity(self, z):
        t = 1 - z / self.height
        return self.top - self.slope * t * (1 + t * (0.5 + t * ((self.bend - 2) / 3 - 0.25 * self.bend * t)))

    def start(self, z):
        return numpy.where(z < self.height, self.velocity(z), numpy.interp(z, self.z, self.u))

    def mixing_length(self, z):
        return numpy.where(z < self.height, numpy.interp(z, self.inside, self.lengths), self.above(z))


def kernel_sums(width):
    """Sums of the kernel's gradient factor over a row, by its distance in rows; h = width dx."""
    reach = int(numpy.ceil(2 * width))
    factor = lambda r: -5 * 7 / (4 * numpy.pi) * max(0.0, 1 - 0.5 * r / width) ** 3 / width**4
    return {m: sum(factor(numpy.hypot(n, m)) for n in range(-reach, reach + 1)) for m in range(-reach, reach + 1) if m != 0}


def mean_velocity(rows, layer, width):
    """Of the rows in balance, by Newton on the drag and half steps on the eddy viscosity."""
    dz = 1 / rows
    z = (numpy.arange(rows) + 0.5) * dz
    pairs, gradient = numpy.zeros((rows, rows)), numpy.zeros((rows, rows))
    for m, total in kernel_sums(width).items():
        for i in range(max(0, -m), min(rows, rows - m)):
            pairs[i, i + m] = total / dz**2
            gradient[i, i + m] -= total * m
    gradient /= -numpy.sum(pairs * dz**2 * (numpy.arange(rows)[:, None] - numpy.arange(rows)) ** 2, axis=1)[:, None] * dz
    gradient -= numpy.diag(gradient.sum(axis=1))
    lengths = layer.mixing_length(z)
    drag = layer.row_drag(z, dz)
    u = layer.start(z)
    for _ in range(1000):
        roots = numpy.sqrt(0.5 * lengths**2 * numpy.abs(gradient @ u))
        weights = (roots[:, None] + roots) ** 2 * pairs
        matrix = numpy.diag(weights.sum(axis=1) - 2 * drag * numpy.abs(u)) - weights
        change = numpy.linalg.solve(matrix, -1 - drag * numpy.abs(u) * u) - u
        u = u + 0.5 * change
        if numpy.max(numpy.abs(change)) < 1e-10:
            break
    return u.mean()


def main():
    for name, closure in CLOSURES.items():
        for width in (1.5, 2.0):
            print(f"\n{name}, h = {width} dx: largest error of the mean velocity, %")
            print("rows of the layer " + "".join(f"{rows:>10d} rows" for rows in (12, 20, 36)))
            for height in (1, 2, 3, 4, 5, 6):
                errors = []
                for rows in (12, 20, 36):
                    layers = [WallLayer(height / rows, 0.6 * height / rows, share * numpy.exp(-8.5 * KAPPA), closure) for share in (0.002, 0.01, 0.05, 0.3)]
                    errors.append(max((100 * (mean_velocity(rows, layer, width) / layer.mean_velocity - 1) for layer in layers), key=abs))
                print(f"{height:>17g} " + "".join(f"{error:>15.2f}" for error in errors))


if __name__ == "__main__":
    main()
