"""Water that goes over an edge: the free overfall and the rating of weirs."""

import math

import h5py
import numpy

import figures
from check import Check
from open_end_checks import account, depth_by_area, surface_of
from options import options_text

WEIR_HEIGHT = 0.3
CREST_LENGTH = 0.3


def overfall(study):
    case = "cases/open-ends/free-overfall.toml"
    check = Check("open_overfall", "Free overfall",
                  "Subcritical flow to the edge of a bed that ends: the depth over the edge against 0.715 of the critical depth (Rouse 1936), at two spacings.")
    figure = figures.Figure(1, width=7)
    axes = figure.panel("distance from the edge over $h_c$", "depth over $h_c$", "mean from 4 s on")
    figures.exact(axes, [-10, 0], [1, 1], "critical depth")
    figures.exact(axes, [0], [0.715], "Rouse (1936)", marker="o", linestyle="none")
    spacings = [5] if study.quick else [5, 10]
    for number, spacing in enumerate(spacings):
        flow = study.run(f"open_overfall_{spacing}", case, {"numerics.spacing": f'"{spacing} mm"'} if spacing != 5 else {})
        q = float(flow.series["inflow_discharge"][flow.series["time"] > 4.0].mean())
        critical = (q**2 / flow.gravity_z) ** (1 / 3)
        before = numpy.arange(0, 9.01, 0.25)
        depth = depth_by_area(flow, flow.length - before * critical, 1.5 * flow.spacing, 4.0) / critical
        figures.simulated(axes, -before, depth, f"dx {spacing} mm", figures.COLOURS[number])
        check.norm(f"depth over the edge against 0.715 h_c, {critical / flow.spacing:.0f} rows of h_c", float(depth[0] / 0.715 - 1), 0.03)
        check.norm(f"where the depth is critical, in h_c before the edge, {critical / flow.spacing:.0f} rows (3 to 4, Henderson 1966)",
                   float(numpy.interp(1.0, depth, before)), None, "", 2)
        account(check, flow)
        if spacing == 5:
            check.best, check.cost = options_text(flow), flow.cost_text
    check.figures.append((figure.svg(check.name), "Depth along the channel before its edge, from the area of the particles."))
    return check


def sharp_crested(gravity, head, _):
    """Unit discharge over a sharp crest as wide as the channel (Kindsvater & Carter 1957), by the head h over it."""
    return (0.602 + 0.075 * head / WEIR_HEIGHT) * 2 / 3 * math.sqrt(2 * gravity) * (head + 0.001) ** 1.5


def broad_crested(gravity, _, energy_head):
    """Unit discharge over a broad crest with sharp edges (Hager & Schwalt 1994), by the energy head H over it."""
    ratio = energy_head / CREST_LENGTH
    return 0.42 * (1 - 2 / 9 / (1 + ratio**4)) * math.sqrt(2 * gravity * energy_head**3)


def _weir(study, name, title, author, law, heads, finer=()):
    """The rating of a weir; `finer`: those of the heads that a spacing of 2 mm resolves."""
    case = f"cases/open-ends/{name}-weir.toml"
    check = Check(f"open_{name.split('-')[0]}_weir", title,
                  f"The discharge of five heads, {heads[0] * 1e3:.0f} to {heads[-1] * 1e3:.0f} mm, against that of {author} for the head that the particles stand at.")
    gravity = 9.81
    measured_heads, discharges, laws = [], [], []
    for head in heads[2:3] if study.quick else heads:
        # The level is that of the law for a still pool; what the particles make of it is measured.
        q = law(gravity, head, head)
        depth = f'"{1e3 * (WEIR_HEIGHT + head):.0f} mm"'
        flow = study.run(f"{check.name}_{1e3 * head:.0f}", case, {
            "channel.depth": depth, "inflow.unit_discharge": f'"{q:.5f} m2/s"', "start.water_z": f'["0 mm", "0 mm", {depth}, {depth}]',
            **({"numerics.spacing": '"2 mm"'} if head in finer else {})})
        begin, pool = flow.parameters["run"]["average_from"], flow.parameters["solid"][0]["x"][0]
        with h5py.File(flow.folder / "results.h5", "r") as file:
            surface = file["/surface"]
            time, x = surface["time"][:], surface["x"][:]
            gauge = (x > 0.4 * pool) & (x < 0.65 * pool)
            level = float(numpy.nanmean(surface["elevation"][numpy.searchsorted(time, begin):, gauge]))
        q = float(flow.series["inflow_discharge"][flow.series["time"] > begin].mean())
        measured = level - WEIR_HEIGHT
        measured_heads.append(measured)
        discharges.append(q)
        laws.append(law(gravity, measured, measured + (q / level) ** 2 / (2 * gravity)))
        check.norm(f"discharge, {1e3 * head:.0f} mm of head expected, {head / flow.spacing:.0f} rows", q / laws[-1] - 1, 0.03)
        account(check, flow)
        if len(laws) == 3 or study.quick:
            check.best, check.cost = options_text(flow), flow.cost_text
    figure = figures.Figure(1, width=6)
    axes = figure.panel("head over the crest (mm)", "unit discharge (l/s per m)", "")
    figures.exact(axes, 1e3 * numpy.array(measured_heads), 1e3 * numpy.array(laws), author)
    figures.simulated(axes, 1e3 * numpy.array(measured_heads), 1e3 * numpy.array(discharges), "particles")
    check.figures.append((figure.svg(check.name), "The rating: discharge by the head that the pool stands at."))
    return check


def sharp_weir(study):
    return _weir(study, "sharp-crested", "Sharp-crested weir", "Kindsvater & Carter (1957)", sharp_crested,
                 [0.06, 0.09, 0.12, 0.16, 0.2])


def broad_weir(study):
    return _weir(study, "broad-crested", "Broad-crested weir", "Hager & Schwalt (1994)", broad_crested,
                 [0.09, 0.105, 0.12, 0.15, 0.18], finer=(0.09, 0.105))


def _height_of_pool(flow, place, width, start):
    """Height up to which water fills the space beside a place without a gap, mean over the snapshots from a time on, m."""
    step = 2 * flow.spacing
    filled = numpy.zeros(round(flow.depth / step))
    for s in flow.snapshots():
        if s.time >= start:
            near = (s.x >= place) & (s.x < place + width)
            filled += numpy.histogram(s.z[near], step * numpy.arange(len(filled) + 1))[0]
    filled /= filled[0]
    gap = int(numpy.argmax(filled < 0.5))
    return step * (gap - 0.5 + float(numpy.interp(0.5, [filled[gap], filled[gap - 1]], [1, 0])))


def drop_structure(study):
    case = "cases/open-ends/drop.toml"
    check = Check("open_drop", "Drop",
                  "Subcritical flow over a drop: the depth behind it, the pool under the nappe and the length of the drop against Rand (1955).")
    flow = study.run("open_drop", case)
    start = flow.parameters["run"]["average_from"]
    height, edge = max(flow.parameters["solid"][0]["z"]), max(flow.parameters["solid"][0]["x"])
    q = float(flow.series["inflow_discharge"][flow.series["time"] > start].mean())
    number = q**2 / (flow.gravity_z * height**3)
    behind = depth_by_area(flow, edge + 0.5, 0.2, start)
    check.norm("depth behind the drop against 0.54 h D^0.425", behind / (0.54 * height * number**0.425) - 1, 0.08)
    check.norm("depth of the pool against h D^0.22", _height_of_pool(flow, edge, 6 * flow.spacing, start) / (height * number**0.22) - 1, 0.08)
    places = numpy.arange(0.02, 0.4, 2 * flow.spacing)
    depth = depth_by_area(flow, edge + places, 2 * flow.spacing, start)
    impact = int(numpy.argmax(depth < 0.5 * height))
    length = places[impact + int(numpy.argmax(depth[impact:] < 1.05 * behind))]
    check.norm("length up to where the depth is that, against 4.3 h D^0.27", float(length / (4.3 * height * number**0.27) - 1), 0.08)
    check.best, check.cost = options_text(flow), flow.cost_text
    account(check, flow)
    return check


def _discharge(flow):
    """Times and unit discharges of the standard section of a run."""
    with h5py.File(flow.folder / "results.h5", "r") as file:
        group = file["/probes/standard_flow_rate"]
        return group["time"][:], group["flow_rate"][:, 0]


def submerged_weir(gravity, head, tailwater, weir_height):
    """Unit discharge over a sharp crest (Rehbock 1929) that the water below it covers by `tailwater`, m (Villemonte 1947)."""
    free = (0.602 + 0.083 * head / weir_height) * 2 / 3 * math.sqrt(2 * gravity) * head**1.5
    return free * (1 - max(0.0, tailwater / head) ** 1.5) ** 0.385


def pool_and_weir(study):
    case = "cases/solids/pool-and-weir.toml"
    check = Check("pool_and_weir", "A pool-and-weir fish pass",
                  "One pool of many, driven by its slope: level, discharge and the water behind the weir stay what they are; without the density relaxation the particles drift apart and the level rises.")
    figure = figures.Figure(2)
    levels, discharges = (figure.panel("time t (s)", label, "") for label in ("mean level (m)", "discharge per unit width (m2/s)"))
    variants = [("5 mm", {}), ("3.3 mm", {"numerics.spacing": '"3.3333 mm"'}), ("5 mm, density_relaxation = 0", {"numerics.density_relaxation": "0"})]
    for number, (name, settings) in enumerate(variants[:1] if study.quick else variants):
        flow = study.run(f"pool_and_weir_{number}", case, settings)
        weir = flow.parameters["solid"][0]
        time, level = flow.series["time"], flow.series["mean_level"]
        times, q = _discharge(flow)
        early = lambda at, values: float(numpy.nanmean(values[(at > 6) & (at <= 12)]))
        late = lambda at, values: float(numpy.nanmean(values[at > 24]))
        held = number < 2  # the last one shows what is missing without the relaxation
        check.norm(f"{name}: mean level, 24 to 30 s against 6 to 12 s, over the depth", (late(time, level) - early(time, level)) / flow.depth, 0.002 if held else None)
        check.norm(f"{name}: discharge, the same", late(times, q) / early(times, q) - 1, 0.01 if held else None)
        volume = float(flow.mass.mean()) / flow.density
        x0, x1, z0, z1 = max(weir["x"]) + 2 * flow.spacing, flow.length - 4 * flow.spacing, 4 * flow.spacing, max(weir["z"]) - 4 * flow.spacing
        fills = [((s.x > x0) & (s.x < x1) & (s.z > z0) & (s.z < z1)).sum() * volume / ((x1 - x0) * (z1 - z0)) for s in flow.snapshots() if s.time > 24]
        check.norm(f"{name}: volume of the particles behind the weir over their room, less one, 24 to 30 s", float(numpy.mean(fills)) - 1, 0.01 if held else None)
        for axes, at, values in ((levels, time, level), (discharges, times, q)):
            parts = numpy.array_split(numpy.arange(len(at)), round(at[-1] / 0.5))
            figures.simulated(axes, [at[i].mean() for i in parts], [numpy.nanmean(values[i]) for i in parts], name, figures.COLOURS[number])
        if not held:
            continue
        surface_time, x, elevation = surface_of(flow)
        mean = numpy.nanmean(elevation[surface_time > 10], axis=0) - flow.parameters["channel"]["slope"] * x
        above = lambda begin, end: float(mean[(x > begin) & (x < end)].mean())
        crest = max(weir["z"]) - flow.parameters["channel"]["slope"] * sum(set(weir["x"])) / 2
        head, tailwater = above(0.12, 0.22) - crest, above(0.42, 0.48) - crest
        check.norm(f"{name}: discharge against that over a submerged sharp crest with the head of {1e3 * head:.1f} mm in the pool",
                   float(q[times > 10].mean()) / submerged_weir(flow.gravity_z, head, tailwater, max(weir["z"])) - 1)
        if number == 0:
            check.best, check.cost = options_text(flow), flow.cost_text
            check.norm(f"{name}: forces of bed and weir over the weight component, less one, from 10 s on", float(flow.values["force_balance_error"]), 0.01)
    check.figures.append((figure.svg(check.name), "Mean level and discharge in time, means over half a second."))
    return check


CHECKS = {"pool_and_weir": pool_and_weir, "open_drop": drop_structure, "open_overfall": overfall, "open_sharp_weir": sharp_weir, "open_broad_weir": broad_weir}
