"""Channels with vegetation: emergent stems, submerged canopies, patches along and across the channel."""

import json
import math
import subprocess

import h5py
import numpy
from matplotlib.path import Path

import figures
from check import Check
from open_end_checks import account, depth_by_area
from options import options_text
from runs import ROOT

KAPPA = 0.41


def cheng_nguyen(reynolds):
    return 50 / reynolds**0.43 + 0.7 * (1 - math.exp(-reynolds / 15000))


def stems_of(flow):
    """The first patch of a case: frontal area a and solid fraction phi, and its keys."""
    stems = flow.parameters["vegetation"][0]
    n, d = stems["stems_per_area"], stems["stem_diameter"]
    return n * d, n * math.pi / 4 * d**2, stems


def emergent_velocity(flow):
    """U of the balance of the weight and the drag of emergent stems."""
    a, phi, stems = stems_of(flow)
    constant = stems["drag_coefficient"]
    velocity = 0.1
    for _ in range(200):
        reynolds = velocity * (1 - phi) / a / flow.viscosity
        coefficient = cheng_nguyen(reynolds) if constant == "cheng-nguyen" else constant
        velocity = math.sqrt(2 * flow.gravity_x * (1 - phi) / (coefficient * a))
    return velocity


def emergent(study):
    check = Check("emergent_stems", "Emergent stems",
                  "A uniform flow through emergent stems, U = sqrt(2 g S0 (1 - phi)/(C_D a)), from a start that is 30 % slower; C_D constant and by Cheng & Nguyen (2011).")
    space = {"channel.dimensions": 3, "channel.width": '"40 mm"', "numerics.spacing": '"4 mm"'}
    steep = {"channel.slope": 0.02, "start.velocity": '"0.25 m/s"'}
    for name, case, settings in [("constant C_D", "emergent", {}), ("Cheng & Nguyen", "emergent-cheng-nguyen", {}),
                                 ("constant C_D, in space", "emergent", space), ("Cheng & Nguyen, in space", "emergent-cheng-nguyen", space),
                                 ("constant C_D, slope 0.02", "emergent", steep), ("constant C_D, 6 mm", "emergent", {"numerics.spacing": '"6 mm"'})]:
        if study.quick and name not in ("constant C_D", "Cheng & Nguyen"):
            continue
        flow = study.run("emergent_" + "".join(c if c.isalnum() else "_" for c in name), f"cases/vegetation/{case}.toml", settings)
        check.norm(f"mean velocity, {name}", flow.values["total_mean_velocity"] / emergent_velocity(flow) - 1, 0.005)
        check.norm(f"vegetation's drag over the weight, less one, {name}", flow.values["vegetation_over_gravity"] - 1, 0.005)
        if not check.best:
            check.best, check.cost = options_text(flow), flow.cost_text
            check.budgets_of(flow, energy=False)
    return check


def case_text(depth, height, stems_per_area, spacing=None, slope=0.001, bed='kind = "slip"', closure="nezu-rodi", coefficient=1.0):
    return f"""
[channel]
slope = {slope}
depth = {depth}
length = {depth}
[bed]
{bed}
[[vegetation]]
name = "stems"
stems_per_area = {stems_per_area}
stem_diameter = 0.006
height = {height}
drag_coefficient = {coefficient}
[turbulence]
closure = "{closure}"
[numerics]
spacing = {spacing or depth / 20}
[run]
until = "40 s"
average_from = "20 s"
"""


def baptist(gravity, slope, depth, height, drag_area, bed_chezy):
    """U of the two-layer formula of Baptist et al. (2007); `drag_area`: C_D a, 1/m."""
    chezy = math.sqrt(1 / (1 / bed_chezy**2 + drag_area * min(height, depth) / (2 * gravity)))
    if depth > height:
        chezy += math.sqrt(gravity) / KAPPA * math.log(depth / height)
    return chezy * math.sqrt(depth * slope)


def _column(study, text):
    file = study.folder / "column.toml"
    file.write_text(text)
    return json.loads(subprocess.run([str(study.riffle), "column", str(file), "--json"], cwd=ROOT, check=True, capture_output=True, text=True).stdout)


def baptist_formula(study):
    height = 0.14
    check = Check("submerged_formula", "Submerged canopies: the column twin against Baptist et al.",
                  "Depth-mean velocity of the column twin over a slip bed against the formula of Baptist et al. (2007), over the depth over the height h/k and the density C_D a k.")
    ratios, areas = (1.25, 1.5, 2, 3, 5, 8), (0.3, 1, 2, 4, 8, 16)
    rows = []
    for area in areas:
        row = [f"{area * height:.2f}"]
        for ratio in ratios:
            velocity = _column(study, case_text(ratio * height, height, area / 0.006))["depth_mean_velocity"]
            departure = velocity / baptist(9.81, 0.001, ratio * height, height, area, 1e9) - 1
            row.append(f"{100 * departure:+.1f} %")
            check.norm(f"U, C_D a k = {area * height:.2f}, h/k = {ratio:g}", departure, 0.15)
        rows.append(row)
    check.tables.append(study.table("The column twin against Baptist et al. (2007): U less one", ["C_D a k \\ h/k"] + [f"{r:g}" for r in ratios], rows))
    check.best, check.cost = "nezu-rodi", "milliseconds"
    return check


def _against_column(flow):
    """Depth-mean velocity and rms of the profile against the column twin, over its U."""
    velocity = flow.column["depth_mean_velocity"]
    return (flow.values["depth_mean_velocity"] / velocity - 1,
            float(numpy.sqrt(numpy.mean(flow.profiles["velocity_deviation"] ** 2)) / velocity))


def submerged(study):
    case = "cases/vegetation/submerged.toml"
    check = Check("submerged_canopy", "Submerged canopy",
                  "Particles against the column twin: depth-mean velocity and profile of a canopy a third of the depth high, at three spacings; other depths, slopes and densities.")
    figure = figures.Figure(1, width=6)
    axes = figure.panel("u, m/s", "z, m", "mean from 20 s on")
    for number, spacing in enumerate([7.5] if study.quick else [5, 7.5, 10]):
        flow = study.run(f"submerged_{spacing}", case, {"numerics.spacing": f'"{spacing} mm"'})
        mean, rms = _against_column(flow)
        bar = 0.01 if spacing < 10 else None
        check.norm(f"U against the column, {spacing} mm", mean, bar)
        check.norm(f"rms of the profile over U, {spacing} mm", rms, bar)
        if number == 0:
            z, u = study.column(flow)
            figures.exact(axes, u, z, "column twin")
            check.best, check.cost = options_text(flow), flow.cost_text
            check.budgets_of(flow, energy=False)
        figures.simulated(axes, flow.profiles["velocity"], flow.profiles["z"], f"dx {spacing} mm", figures.COLOURS[number])
    check.figures.append((figure.svg(check.name), "Velocity in and above a canopy of 0.1 m in water of 0.3 m."))
    if study.quick:
        return check
    rows = []
    for label, keys in [
        ("slip bed", {}), ("deeper, h/k = 6", {"depth": 0.6, "spacing": 0.015}), ("shallow, h/k = 1.25, 4 mm", {"depth": 0.125, "spacing": 0.004}),
        ("sparse, a = 0.6 1/m", {"stems_per_area": 100}), ("dense, a = 18 1/m", {"stems_per_area": 3000}),
        ("slope 1e-4", {"slope": 1e-4}), ("slope 0.01", {"slope": 0.01}), ("ramp", {"closure": "ramp"}),
        ("smooth bed", {"bed": 'kind = "smooth"'}), ("gravel, k_s 20 mm", {"bed": 'kind = "roughness"\nequivalent_roughness = 0.02'}),
        ("spheres", {"bed": 'kind = "spheres"\nroughness_height = "0.4 D"', "spacing": 0.004, "depth": 0.15, "height": 0.06}),
    ]:
        file = study.folder / f"submerged_{len(rows)}.toml"
        file.write_text(case_text(**({"depth": 0.3, "height": 0.1, "stems_per_area": 600, "spacing": 0.0075} | keys)))
        flow = study.run(f"submerged_case_{len(rows)}", str(file), {})
        mean, rms = _against_column(flow)
        rows.append([label, f"{100 * mean:+.2f} %", f"{100 * rms:.2f} %", f"{flow.values['vegetation_over_gravity']:.3f}",
                     f"{flow.column['vegetation_share']:.3f}", f"{flow.values['velocity_fluctuation']:.1e}"])
        # So mild a slope is beyond what the particles' disorder leaves of it.
        check.norm(f"U against the column, {label}", mean, None if label == "slope 1e-4" else 0.01)
        check.norm(f"rms of the profile over U, {label}", rms, None)
    check.tables.append(study.table("Submerged canopies: particles against the column twin",
                                    ["canopy", "U", "rms of the profile", "vegetation's share", "the twin's", "u', m/s"], rows))
    return check


def bank(study):
    case = "cases/vegetation/vegetated-bank.toml"
    check = Check("vegetated_bank", "Vegetated banks",
                  "Dense stems along half of a channel's width, sparse ones in the rest: the velocity across the channel against the section twin.")
    flow = study.run("vegetated_bank", case, {})
    section = json.loads(subprocess.run([str(study.riffle), "section", case, "--json", "-"], cwd=ROOT, check=True, capture_output=True, text=True).stdout)
    with h5py.File(flow.folder / "results.h5", "r") as file:
        field = file["/mean_field"]
        late = field["time"][:] > flow.parameters["run"]["average_from"] + 1e-9
        count = field["count"][:][late]
        velocity = numpy.where(count > 0, numpy.nan_to_num(field["velocity"][:][late]) * count, 0.0)
        places, across = field["y"][:], velocity.sum(axis=(0, 1, 3)) / count.sum(axis=(0, 1, 3))
    twin = section["section"]
    y, u = numpy.array(twin["y"]), numpy.array(twin["velocity"]).reshape(len(twin["z"]), -1).mean(axis=0)
    expected = numpy.interp(places, y, u)
    check.norm("mean velocity", flow.values["total_mean_velocity"] / section["bulk_velocity"] - 1, 0.02)
    check.norm("rms of U(y) over the bulk velocity", float(numpy.sqrt(numpy.mean((across - expected) ** 2)) / section["bulk_velocity"]), 0.05)
    figure = figures.Figure(1, width=6)
    panel = figure.panel("y, m", "U, m/s", "mean from 20 s on")
    figures.exact(panel, y, u, "section twin")
    figures.simulated(panel, places, across, "particles", figures.COLOURS[0])
    check.figures.append((figure.svg(check.name), "Velocity across a channel with dense stems along its bank."))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


def _varied_depth(flow, q, places):
    """Depth at some places of steady gradually varied flow from the depth at the last one: the friction of the log law of the bed and
    the drag of the stems at the velocity q/h."""
    a, phi, stems = stems_of(flow)
    zero_height = flow.parameters["bed"]["equivalent_roughness"] * math.exp(-8.5 * KAPPA)
    depths = [places[1]]
    x, h = places[0][::-1], places[1]
    for right, left in zip(x[:-1], x[1:]):
        friction = (KAPPA / (math.log(h / zero_height) - 1)) ** 2 * (q / h) ** 2 / (flow.gravity_z * h)
        inside = stems["x_from"] < 0.5 * (left + right) < stems["x_to"]
        drag = 0.5 * stems["drag_coefficient"] * a / (1 - phi) * (q / h) ** 2 / flow.gravity_z if inside else 0.0
        slope = (flow.gravity_x / flow.gravity_z - friction - drag) / (1 - q**2 / (flow.gravity_z * h**3))
        h -= slope * (right - left)
        depths.append(h)
    return numpy.array(depths[::-1])


def patch(study):
    case = "cases/vegetation/patch.toml"
    check = Check("vegetation_patch", "A patch of stems between open ends",
                  "The backwater before a patch of emergent stems against steady gradually varied flow with their drag; the force on them against that of the particles between them; the account of the particles.")
    flow = study.run("vegetation_patch", case, {})
    begin = flow.parameters["run"]["average_from"]
    late = flow.series["time"] > begin
    account(check, flow)
    q = float(flow.series["inflow_discharge"][late].mean())
    a, phi, stems = stems_of(flow)
    x = numpy.linspace(0.2, 2.2, 401)
    depth = depth_by_area(flow, x, 10 * flow.spacing, begin)
    # Of the water beside the outflow, whose depth is given; the mean takes out the rows of the particles.
    varied = _varied_depth(flow, q, (x, float(depth[-20:].mean())))
    before, behind = (x > 0.6) & (x < 0.85), (x > 1.6) & (x < 1.85)
    check.norm("depth before the patch against gradually varied flow", float(depth[before].mean() / varied[before].mean() - 1), 0.01)
    check.norm("depth behind the patch, the same", float(depth[behind].mean() / varied[behind].mean() - 1), 0.01)
    check.norm("rise over the patch, over that of gradually varied flow, less one",
               float((depth[before].mean() - depth[behind].mean()) / (varied[before].mean() - varied[behind].mean()) - 1), None)
    forces = []
    for s in flow.snapshots():
        if s.time >= begin:
            inside = (s.x > stems["x_from"]) & (s.x < stems["x_to"])
            forces.append(flow.mass[0] * (0.5 * stems["drag_coefficient"] * a / (1 - phi) * numpy.hypot(s.u, s.w) * s.u)[inside].sum())
    stored = float(flow.forces["vegetation_drag"][flow.forces["time"] > begin].mean())
    check.norm("recorded force on the stems against that of the particles between them", stored / float(numpy.mean(forces)) - 1, 0.02)
    figure = figures.Figure(1, width=7)
    panel = figure.panel("x, m", "depth, m", "mean from 15 s on")
    figures.exact(panel, x, varied, "gradually varied flow")
    figures.simulated(panel, x[::8], depth[::8], "particles", figures.COLOURS[0])
    check.figures.append((figure.svg(check.name), "Depth along the channel; the stems stand from 0.9 to 1.5 m."))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


def island(study):
    case = "cases/vegetation/island.toml"
    check = Check("vegetated_island", "An island of reeds",
                  "A stream of 0.3 m/s, 60 mm deep, goes through and around a round patch of emergent stems, given by its outline. Over a slip bed, without a closure, "
                  "its head along the axis falls by what the stems take there, and its wake has the velocity of arrays of cylinders in a flume; the force on them against that of the particles between them.")
    flow = study.run("vegetated_island", case, {})
    begin = flow.parameters["run"]["average_from"]
    account(check, flow)
    a, phi, stems = stems_of(flow)
    corners = numpy.array(stems["x"]), numpy.array(stems["y"])
    outline = Path(numpy.column_stack(corners))
    middle = corners[1].mean()
    left, right = corners[0].min(), corners[0].max()
    resistance = 0.5 * stems["drag_coefficient"] * a / (1 - phi)
    places = numpy.arange(0.1, 1.3, flow.spacing)
    forces, axis, squares, braked, drift = [], [], [], [], []
    for s in flow.snapshots():
        if s.time < begin:
            continue
        inside = outline.contains_points(numpy.column_stack((s.x, s.y)))
        square = s.u**2 + s.v**2 + s.w**2
        forces.append((flow.mass[0] * resistance * numpy.sqrt(square) * s.u)[inside].sum())
        near = abs(s.y - middle) < 1.5 * flow.spacing
        bins = numpy.digitize(s.x[near], places) - 1
        number = numpy.bincount(bins[bins >= 0], minlength=len(places))[:-1]
        for values, means in ((s.u, axis), (square, squares), (s.u * numpy.sqrt(square), braked)):
            means.append(numpy.bincount(bins[bins >= 0], weights=values[near][bins >= 0], minlength=len(places))[:-1] / number)
        drift.append(s.v[inside].mean())
    u, square, braked = (numpy.mean(means, axis=0) for means in (axis, squares, braked))
    x = 0.5 * (places[:-1] + places[1:])
    stored = float(flow.forces["vegetation_drag"][flow.forces["time"] > begin].mean())
    check.norm("recorded force on the stems against that of the particles between them", stored / float(numpy.mean(forces)) - 1, 0.02)
    with h5py.File(flow.folder / "results.h5", "r") as file:
        surface = file["/surface_map"]
        rows = abs(surface["y"][:] - middle) < 1.5 * flow.spacing
        level = numpy.nanmean(surface["elevation"][:][surface["time"][:] > begin][:, rows], axis=(0, 1))
        level = numpy.interp(x, surface["x"][:], level)
    head = level + square / (2 * flow.gravity_z)
    # Where the surface is as good as level again: beside the edges of the island it bends within a depth.
    before, behind = (x > left - 0.12) & (x < left - 0.06), (x > right + 0.12) & (x < right + 0.36)
    within = numpy.clip((numpy.minimum(x + flow.spacing / 2, right) - numpy.maximum(x - flow.spacing / 2, left)) / flow.spacing, 0, 1)
    gone = numpy.cumsum(within * resistance * braked) * flow.spacing / flow.gravity_z
    lost = head[before].mean() - head[behind].mean()
    check.norm("head lost along the axis against what the stems take there", float(lost / gone[-1] - 1), 0.05)
    far = float(u[x < 0.2].mean())
    # Of round arrays of cylinders in a flume; the coefficient has a scatter of 0.08 there.
    blockage = math.sqrt(stems["drag_coefficient"] * a * (right - left))
    check.norm("velocity behind the island over that of the stream, against 1 - 0.33 sqrt(C_D a D) (Chen et al. 2012)",
               float(u[behind].mean() / far - (1 - 0.33 * blockage)), 0.08 * blockage)
    check.norm("velocity across it, mean of the water between the stems, over that of the stream", float(numpy.mean(drift) / far), 0.02)
    figure = figures.Figure(3, width=13)
    last = flow.snapshot(len(flow.names) - 1)
    edges = [numpy.arange(0, flow.parameters["channel"][extent] + 1e-9, 0.02) for extent in ("length", "width")]
    number, *_ = numpy.histogram2d(last.x, last.y, bins=edges)
    along, *_ = numpy.histogram2d(last.x, last.y, bins=edges, weights=last.u)
    panel = figure.panel("x, m", "y, m", f"u over the depth, m/s, at {last.time:.3g} s")
    drawn = panel.pcolormesh(*edges, (along / numpy.maximum(number, 1)).T, cmap="viridis", rasterized=True)
    panel.plot(*(numpy.append(c, c[0]) for c in corners), color="#ffffff", lw=1)
    panel.set_aspect("equal")
    panel.figure.colorbar(drawn, ax=panel, orientation="horizontal", pad=0.25)
    panel = figure.panel("x, m", "u, m/s", f"axis, mean from {begin:g} s on")
    figures.simulated(panel, x, u, "particles", figures.COLOURS[0])
    panel.axvspan(left, right, color="#7fae5a", alpha=0.3, lw=0)
    panel = figure.panel("x, m", "head, mm", "level and velocity head on the axis")
    figures.simulated(panel, x, 1e3 * head, "particles", figures.COLOURS[0])
    figures.exact(panel, x, 1e3 * (head[before].mean() - gone), "less what the stems take")
    panel.axvspan(left, right, color="#7fae5a", alpha=0.3, lw=0)
    check.figures.append((figure.svg(check.name), "Velocity and head along the axis of an island of reeds; the green band is the island."))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


CHECKS = {"emergent_stems": emergent, "submerged_formula": baptist_formula, "submerged_canopy": submerged, "vegetated_bank": bank, "vegetation_patch": patch, "vegetated_island": island}
