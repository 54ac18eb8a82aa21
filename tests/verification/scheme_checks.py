"""What fails: the thesis' literal scheme against the continuum limit of its own model."""

import math

import numpy

import figures
from check import Check
from options import options_text
from table import Table


def _rows(flow, shots):
    """Height, mean u and the twin's u of layers of a spacing, over snapshots."""
    z = numpy.concatenate([s.z for s in shots])
    u = numpy.concatenate([s.u for s in shots])
    count = round(flow.depth / flow.spacing)
    index = numpy.clip((z / flow.depth * count).astype(int), 0, count - 1)
    number = numpy.maximum(numpy.bincount(index, minlength=count), 1)
    return numpy.bincount(index, weights=z, minlength=count) / number, numpy.bincount(index, weights=u, minlength=count) / number


def thesis(study):
    check = Check("thesis", "The thesis' literal scheme against its own continuum limit",
                  "Flow condition 2 from the column twin's steady profile, with the numerics as printed in the thesis (cubic spline, h = 1.5 dx, "
                  "symmetric pressure form, dynamic walls, MLS; c<sub>0</sub> = 16 m/s and dx = 2 mm, which change nothing of it) and with "
                  "Riffle's. Both have the same closure, drag and bed, so both have this profile as their continuum limit, and should stay on it. "
                  "The literal scheme loses the layered order of its particles within a second; among disordered particles the usual pair "
                  "form turns some tenths of a percent of the pressure into shear stress, as much as the slope's own, and the flow brakes. "
                  "Refinement does not cure it; the corrected pressure form does.")
    duration = 2 if study.quick else 6
    common = {"channel.length": '"0.1 m"', "run.until": f'"{duration} s"', "run.average_from": f'"{duration / 2} s"', "output.snapshot_interval": '"0.1 s"'}
    case = "cases/rough-bed-2d/condition-2.toml"
    ours = study.run("thesis-riffle", case, common)
    theirs = study.run("thesis-literal", case, {**common, "numerics.preset": '"thesis"', "numerics.spacing": '"2 mm"', "numerics.sound_speed": '"16 m/s"',
                                                "numerics.smoothing_ratio": "1.5", "numerics.wall_layers": "2"})
    table = Table("Condition 2 against the column twin", ["scheme", "mean velocity in the end, departure %", "particle order in the end", "depth, departure %", "s of a core"])
    figure = figures.Figure(2)
    profile = figure.panel("velocity u (m/s)", "height z (mm)", f"the last second of {duration} s")
    history = figure.panel("time t (s)", "mean velocity / the twin's")
    departures = {}
    for name, flow, colour in (("Riffle", ours, figures.COLOURS[0]), ("thesis, literal", theirs, figures.COLOURS[1])):
        twin = flow.column["total_mean_velocity"]
        mean = flow.series["total_mean_velocity"] / twin
        departures[name] = mean[-1] - 1
        table.rows.append([name, f"{100 * departures[name]:+.1f}", f"{flow.series['particle_order'][-1]:.2f}",
                           f"{100 * (flow.mean_height[-1] / flow.mean_height[0] - 1):+.2f}", f"{flow.cost:.0f}"])
        z, u = _rows(flow, [s for s in flow.snapshots() if s.time > duration - 1])
        figures.simulated(profile, u, 1e3 * z, name, colour)
        figures.simulated(history, flow.series["time"], mean, name, colour, 80)
    z, u = study.column(ours)
    figures.exact(profile, u, 1e3 * z, "column twin")
    figures.exact(history, [0, duration], [1, 1], "column twin")
    check.tables.append(table)
    check.figures.append((figure.svg(check.name), "Profile and mean velocity: column twin (lines), Riffle's scheme and the literal scheme of the thesis (points)."))
    check.norm(f"mean velocity after {duration} s against the column twin, Riffle's scheme", departures["Riffle"], 0.01)
    check.norm("the same, literal scheme of the thesis (fails)", departures["thesis, literal"])
    check.best, check.cost = options_text(ours), ours.cost_text
    check.budgets_of(ours, energy=False)
    return check


CHECKS = {"thesis": thesis}
