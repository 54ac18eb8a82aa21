"""Unsteady flow in one dimension (de Saint-Venant), by MacCormack's scheme: the reference of floods."""

import numpy


def saint_venant(length, slope, gravity, friction_slope, discharge, depth, start, until, cells=400, momentum_coefficient=1.0):
    """Solve h_t + q_x = 0, q_t + (beta q^2/h + g h^2/2)_x = g h (S_0 - S_f) in a channel of a unit of width.

    friction_slope(h, q) of arrays; discharge(t) at the upstream end, depth(t) at the downstream one, subcritical flow; start: the depths
    and discharges at t = 0, functions of x. Returns times, places, h and q [time, place]. Second order in time and space."""
    x = numpy.linspace(0.0, length, cells + 1)
    dx = x[1] - x[0]
    h, q = start[0](x), start[1](x)
    time, times, depths, discharges = 0.0, [0.0], [h.copy()], [q.copy()]

    def rates(h, q, forward):
        """Rates of change with one-sided differences; at the ends, those from within."""
        flux = momentum_coefficient * q**2 / h + 0.5 * gravity * h**2
        dq, df = numpy.diff(q) / dx, numpy.diff(flux) / dx
        sides = (lambda d: numpy.append(d, d[-1])) if forward else (lambda d: numpy.insert(d, 0, d[0]))
        return -sides(dq), -sides(df) + gravity * h * (slope - friction_slope(h, q))

    def hold_ends(h, q, t):
        q[0], h[-1] = discharge(t), depth(t)

    while time < until - 1e-9:
        step = min(0.8 * dx / float((numpy.abs(q / h) + numpy.sqrt(gravity * h)).max()), until - time)
        first = rates(h, q, True)
        h1, q1 = h + step * first[0], q + step * first[1]
        hold_ends(h1, q1, time + step)
        second = rates(h1, q1, False)
        h, q = h + 0.5 * step * (first[0] + second[0]), q + 0.5 * step * (first[1] + second[1])
        time += step
        hold_ends(h, q, time)
        times.append(time)
        depths.append(h.copy())
        discharges.append(q.copy())
    return numpy.array(times), x, numpy.array(depths), numpy.array(discharges)
