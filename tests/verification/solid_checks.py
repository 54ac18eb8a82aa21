"""Solids in three dimensions whose walls end at their true surface: rest beside them, laminar flow along faces at angles to the rows."""

import math

import numpy

import exact
import figures
from check import Check
from options import options_text
from table import Table

STILL = {"sphere": "cases/checks/sphere-at-rest.toml", "V-shaped channel": "cases/checks/v-channel-at-rest.toml"}


def rest_in_space(study):
    check = Check("rest_in_space", "Still water around a sphere and in a V-shaped channel",
                  "Three dimensions, water's own viscosity. The water settles for 2 s; the pressure is corrected by the mean of the correction. The walls of the solid stand on "
                  "the lattice of the water, or end at its true surface, up to which the start is packed. Snapshots of each 0.1 s.")
    interval = {"output.snapshot_interval": '"0.1 s"'}
    table = Table(f"{check.title}, 5 to 6 s", ["case", "choice", "largest speed / √(gH)", "rms"])
    for name, case in STILL.items():
        for choice, packed in {"walls on the lattice": "false", "true surface": "true"}.items():
            flow = study.run(f"{check.name}-{name.split()[0].lower()}-{choice.split()[-1]}", case, {**interval, "start.packed": packed})
            largest, rms = flow.speeds(5.0, 6.1)
            check.norm(f"{name}, {choice}: largest speed of any particle, 5 to 6 s, over √(gH)", largest, 1e-2, "", 3)
            check.norm(f"{name}, {choice}: rms of the speeds, 5 to 6 s, over √(gH)", rms, 2e-3, "", 3)
            table.rows.append([name, choice, f"{largest:.3g}", f"{rms:.2g}"])
            check.best, check.cost = options_text(flow), flow.cost_text
    if study.quick:
        return check
    case = STILL["V-shaped channel"]
    for choice, settings in {
            "no settling": {"start.settling_time": '"0 s"'},
            "correction of each moment": {"numerics.pressure_correction_time": '"0 s"'},
            "h = 1.83 dx": {"numerics.smoothing_ratio": "1.83"},
            "h = 2.1 dx, 5 layers": {"numerics.smoothing_ratio": "2.1", "numerics.wall_layers": "5"},
            "square lattice": {"start.lattice": '"square"'},
            "reference pressure": {"numerics.reference_pressure": "hydrostatic"}}.items():
        flow = study.run(f"{check.name}-{len(table.rows)}", case, {**interval, "start.packed": "true", **settings})
        largest, rms = flow.speeds(5.0, 6.1)
        table.rows.append(["V-shaped channel", f"true surface, {choice}", f"{largest:.3g}", f"{rms:.2g}"])
    check.tables.append(table)
    return check


def _between_45(force, nu, depth, y, z):
    """Half of a square duct below its diagonal, the corner in the middle of the channel."""
    across = y - 1.1 * depth
    return exact.square_duct(force, nu, math.sqrt(2) * depth, (z + across) / math.sqrt(2), (z - across) / math.sqrt(2))


def _beside_30(force, nu, depth, y, z):
    """Half of an equilateral duct below an altitude, beside an upright wall at y = H / 4."""
    across = y - 0.25 * depth
    slope, cosine = 1 / math.sqrt(3), math.sqrt(3) / 2
    return exact.equilateral_duct(force, nu, math.sqrt(3) * depth, across, (z - across * slope) * cosine, (2 * depth - z - across * slope) * cosine)


INCLINED = {45: ("cases/checks/laminar-45-degrees.toml", _between_45, lambda y, z: z > abs(y - 1.1)),
            30: ("cases/checks/laminar-30-degrees.toml", _beside_30, lambda y, z: (y > 0.25) & (z > (y - 0.25) / math.sqrt(3)))}


def inclined_sides(study):
    check = Check("inclined_sides", "Laminar flow along sides at 30 and 45 degrees",
                  "Three dimensions, a free surface; the sides are solids whose faces stand at an angle to the rows of particles. Exact: half of a square duct, "
                  "half of an equilateral one. Means over 10 s, in squares of a tenth of the depth.")
    figure = figures.Figure(2, width=8)
    for angle, (case, velocity, holds) in INCLINED.items():
        flow = study.run(f"{check.name}_{angle}", case)
        depth, nu = flow.depth, flow.viscosity
        force = flow.gravity_x
        y, z = numpy.meshgrid((numpy.arange(880) + 0.5) * depth / 400, (numpy.arange(400) + 0.5) * depth / 400)
        theory = numpy.where(holds(y / depth, z / depth), velocity(force, nu, depth, y, z), numpy.nan)
        late = list(flow.snapshots())
        late = [s for s in late if s.time >= late[-1].time - 10]
        places = numpy.concatenate([numpy.column_stack([s.y, s.z]) for s in late])
        simulated = numpy.concatenate([s.u for s in late])
        error = simulated - velocity(force, nu, depth, *places.T)
        square = (places // (0.1 * depth)).astype(int)
        _, index, count = numpy.unique(square[:, 0] * 1000 + square[:, 1], return_inverse=True, return_counts=True)
        means = numpy.bincount(index, error) / count
        largest, mean = numpy.nanmax(theory), numpy.nanmean(theory)
        name = f"{angle} degrees"
        check.norm(f"{name}: rms error of the mean velocity over its largest", math.sqrt((count * means**2).sum() / count.sum()) / largest, 0.01)
        check.norm(f"{name}: mean velocity of the water", simulated.mean() / mean - 1, 0.01)
        check.norm(f"{name}: largest velocity", numpy.percentile(simulated, 99.9) / numpy.nanpercentile(theory, 99.9) - 1)
        axes = figure.panel("u (m/s)", "z / H", name)
        middle = 1.1 if angle == 45 else 0.75
        beside = abs(places[:, 0] / depth - middle) < 0.05
        heights = numpy.arange(0.05 if angle == 45 else 0.35, 1.0, 0.1)
        profile = [simulated[beside & (abs(places[:, 1] / depth - at) < 0.05)].mean() for at in heights]
        line = numpy.linspace(0 if angle == 45 else 0.5 / math.sqrt(3), 1, 100)
        figures.exact(axes, velocity(force, nu, depth, middle * depth + 0 * line, line * depth), line, f"exact, y = {middle:g} H")
        figures.simulated(axes, profile, heights, "simulated")
        check.best, check.cost = options_text(flow), flow.cost_text
    check.figures.append((figure.svg(check.name), "Velocity over the height at one place across the channel."))
    return check


CHECKS = {"rest_in_space": rest_in_space, "inclined_sides": inclined_sides}
