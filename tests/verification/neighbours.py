"""Sums over neighbouring particles, in numpy."""

import numpy


def neighbour_pairs(x, z, radius, periods=(None, None)):
    """Indices i, j of all ordered pairs closer than `radius`, and x_j - x_i, z_j - z_i; `periods` of x and z, or None."""
    cell, count, coordinates = [], [], []
    for values, period in ((x, periods[0]), (z, periods[1])):
        low, extent = (0.0, period) if period else (values.min(), max(values.max() - values.min(), radius))
        number = max(int(extent / radius), 1)
        position = numpy.floor((values - low) / extent * number).astype(int)
        coordinates.append(position % number if period else numpy.clip(position, 0, number - 1))
        count.append(number)
        cell.append(period)
    key = coordinates[0] * count[1] + coordinates[1]
    order = numpy.argsort(key, kind="stable")
    starts = numpy.searchsorted(key[order], numpy.arange(count[0] * count[1] + 1))
    found = []
    # With a period of less than three cells a neighbour cell would be met twice.
    offsets = [sorted({o % n if p and n < 3 else o for o in (-1, 0, 1)}) for n, p in zip(count, cell)]
    for ox in offsets[0]:
        for oz in offsets[1]:
            near = []
            inside = numpy.ones(x.size, dtype=bool)
            for c, o, n, p in zip(coordinates, (ox, oz), count, cell):
                moved = c + o
                if p:
                    moved = moved % n
                else:
                    inside &= (moved >= 0) & (moved < n)
                near.append(moved)
            which = numpy.nonzero(inside)[0]
            other = near[0][which] * count[1] + near[1][which]
            number = starts[other + 1] - starts[other]
            i = numpy.repeat(which, number)
            within = numpy.arange(i.size) - numpy.repeat(numpy.cumsum(number) - number, number)
            j = order[numpy.repeat(starts[other], number) + within]
            dx, dz = x[j] - x[i], z[j] - z[i]
            if periods[0]:
                dx -= periods[0] * numpy.round(dx / periods[0])
            if periods[1]:
                dz -= periods[1] * numpy.round(dz / periods[1])
            close = (dx * dx + dz * dz < radius * radius) & (i != j)
            found.append((i[close], j[close], dx[close], dz[close]))
    return tuple(numpy.concatenate(part) for part in zip(*found))


def velocity_gradients(x, z, u, w, volume, smoothing_length, periods):
    """du/dx, du/dz, dw/dx, dw/dz at the particles, exact for linear fields (moments corrected), Wendland's C2 kernel."""
    i, j, dx, dz = neighbour_pairs(x, z, 2 * smoothing_length, periods)
    q = numpy.hypot(dx, dz) / smoothing_length
    weight = volume[j] * (1 - q / 2) ** 3  # -W'(q) / q, up to a constant
    total = lambda values: numpy.bincount(i, weights=weight * values, minlength=x.size)
    xx, xz, zz = total(dx * dx), total(dx * dz), total(dz * dz)
    determinant = xx * zz - xz * xz
    lonely = determinant <= 1e-6 * (xx + zz) ** 2  # a spray particle, or a row of them: no gradient can be told
    determinant = numpy.where(lonely, 1.0, determinant)
    gradients = []
    for values in (u, w):
        x_sum, z_sum = total(dx * (values[j] - values[i])), total(dz * (values[j] - values[i]))
        gradients.append(numpy.where(lonely, 0.0, (zz * x_sum - xz * z_sum) / determinant))
        gradients.append(numpy.where(lonely, 0.0, (xx * z_sum - xz * x_sum) / determinant))
    return gradients
