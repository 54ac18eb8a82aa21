"""Energy spectra of particles in a periodic cube."""

import numpy

CHUNK = 4096  # points of the grid that are fitted at a time


class Nearest:
    """The nearest of points in a periodic cube, found among those of the cells around."""

    def __init__(self, position, side, number):
        self.position, self.side, self.number = position % side, side, number
        # Some eight points a cell: 27 cells hold many more than are asked for.
        self.cells = max(3, int((len(position) / 8) ** (1 / 3)))
        cell = self._cell(self.position) @ [self.cells**2, self.cells, 1]
        order = numpy.argsort(cell, kind="stable")
        count = numpy.bincount(cell, minlength=self.cells**3)
        slot = numpy.arange(len(cell)) - numpy.repeat(numpy.cumsum(count) - count, count)
        self.members = numpy.full((self.cells**3, count.max()), -1)
        self.members[cell[order], slot] = order
        steps = numpy.arange(-1, 2)
        self.around = numpy.stack(numpy.meshgrid(steps, steps, steps, indexing="ij"), axis=-1).reshape(-1, 3)

    def _cell(self, places):
        return numpy.minimum((places / self.side * self.cells).astype(int), self.cells - 1)

    def query(self, places):
        """Of the nearest to each place, the farthest of them last: numbers, and ways from the place to them."""
        cells = (self._cell(places % self.side)[:, None, :] + self.around) % self.cells
        near = self.members[cells @ [self.cells**2, self.cells, 1]].reshape(len(places), -1)
        away = self.position[near] - places[:, None, :]
        away -= self.side * numpy.round(away / self.side)
        squared = numpy.where(near < 0, numpy.inf, (away**2).sum(axis=-1))
        chosen = numpy.argpartition(squared, self.number - 1, axis=1)[:, :self.number]
        return numpy.take_along_axis(near, chosen, axis=1), numpy.take_along_axis(away, chosen[:, :, None], axis=1)


def velocity_on_grid(position, velocity, side, points, neighbours=32):
    """Velocity at the middles of `points` cells a side: the quadratic function that fits the nearest particles best, with weights that fall
    to 0 at the last of them. The kernel's mean would keep less of the small eddies."""
    nearest = Nearest(position, side, neighbours)
    middles = (numpy.arange(points) + 0.5) * side / points
    places = numpy.stack(numpy.meshgrid(middles, middles, middles, indexing="ij"), axis=-1).reshape(-1, 3)
    result = numpy.empty_like(places)
    for begin in range(0, len(places), CHUNK):
        here = places[begin:begin + CHUNK]
        near, away = nearest.query(here)
        distance = numpy.sqrt((away**2).sum(axis=-1))
        reach = 1.0001 * distance[:, -1:]
        x, y, z = numpy.moveaxis(away / reach[:, :, None], -1, 0)
        share = distance / reach
        basis = numpy.stack([numpy.ones_like(x), x, y, z, x * x, y * y, z * z, x * y, x * z, y * z], axis=-1)
        weighted = basis * ((1 - share) ** 4 * (1 + 4 * share))[:, :, None]
        matrix = numpy.einsum("pni,pnj->pij", weighted, basis)
        sums = numpy.einsum("pni,pnc->pic", weighted, velocity[near])
        result[begin:begin + CHUNK] = numpy.linalg.solve(matrix, sums)[:, 0, :]
    return result.reshape(points, points, points, 3)


def energy_spectrum(velocity, side):
    """Wave numbers (mean of each shell, one wave per side apart), E(k), and the part of it in motion that compresses."""
    points = velocity.shape[0]
    modes = numpy.fft.fftn(velocity, axes=(0, 1, 2)) / points**3
    whole = numpy.fft.fftfreq(points, 1 / points)
    axes = [2 * numpy.pi / side * whole.reshape([-1 if a == b else 1 for b in range(3)]) for a in range(3)]
    squared = sum(axis**2 for axis in axes)
    k = numpy.sqrt(squared)
    along = sum(axis * modes[..., a] for a, axis in enumerate(axes))
    squared[0, 0, 0] = 1
    shell = numpy.rint(k * side / (2 * numpy.pi)).astype(int).ravel()
    count = numpy.bincount(shell)
    mean = lambda values: numpy.bincount(shell, values.ravel()) / count
    wavenumber = mean(k)
    # Each mode has the volume (2 pi / side)^3 among the wave vectors, a shell 4 pi k^2 dk of it.
    density = 4 * numpy.pi * wavenumber**2 * (side / (2 * numpy.pi)) ** 3
    half = slice(1, points // 2 + 1)
    return wavenumber[half], (density * mean(0.5 * (abs(modes) ** 2).sum(axis=-1)))[half], (density * mean(0.5 * abs(along) ** 2 / squared))[half]
