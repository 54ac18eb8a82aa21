"""Flow that changes within a few depths: hydraulic jumps, and water that parts from a step."""

import math

import h5py
import numpy

import figures
from check import Check
from open_end_checks import account, backwater, depth_by_area
from options import options_text

# Froude number at the inflow, 20 mm deep: unit discharge (m2/s), depth that is held at the end (mm), length (m), until and from (s).
JUMPS = {3: (0.02658, 70, 1.0, 25, 5), 2.3: (0.02038, 52.5, 0.8, 15, 5), 4: (0.03544, 97, 1.5, 12, 5)}

# Length behind the step, in its heights, by the Reynolds number of the mean velocity and twice the height of the inflow (Erturk 2008):
# viscosity (m2/s), until (s).
STEPS = {100: (2.922, 2e-5, 8), 200: (4.982, 1e-5, 12), 300: (6.751, 6.6667e-6, 16), 400: (8.237, 5e-6, 20)}


def _one_jump(study, check, froude, axes, colour):
    case = "cases/open-ends/hydraulic-jump.toml"
    q, tailwater, length, until, start = JUMPS[froude]
    settings = {} if froude == 3 else {
        "inflow.unit_discharge": f'"{q} m2/s"', "channel.depth": f'"{tailwater} mm"', "outflow.depth": f'"{tailwater} mm"',
        "channel.length": f'"{length} m"', "run.until": f'"{until} s"'}
    flow = study.run(f"open_jump_{froude}", case, settings)
    g = flow.gravity_z
    with h5py.File(flow.folder / "results.h5", "r") as file:
        surface = file["/surface"]
        time, x, level = surface["time"][:], surface["x"][:], surface["elevation"][:]
    late = time > start
    mean = numpy.nanmean(level[late], axis=0)
    deep = mean[x > 0.9 * flow.length].mean()
    half = 0.5 * (mean[x < 0.1 * flow.length].mean() + deep)
    toes = numpy.array([x[numpy.argmax(row > half)] for row in level[late]])
    place = float(numpy.median(toes))
    # Before the jump, as near to it as the water does not rise yet; behind it, as near as the roller ends.
    before = depth_by_area(flow, max(place - 1.5 * deep, 0.05), 0.01, start)
    begin, end = place + 4 * deep, 0.95 * flow.length
    after = depth_by_area(flow, 0.5 * (begin + end), 0.5 * (end - begin), start)
    local = q / before / math.sqrt(g * before)
    conjugate = 0.5 * before * (math.sqrt(1 + 8 * local**2) - 1)
    energy = lambda h: h + q**2 / (2 * g * h**2)
    name = f"Fr {froude} at the inflow"
    check.norm(f"{name}: Froude number before the jump, {before / flow.spacing:.0f} rows deep", local, None, "", 3)
    check.norm(f"{name}: depth behind the jump against the conjugate one", after / conjugate - 1, 0.03)
    check.norm(f"{name}: loss of energy head against that of the conjugate depths",
               (energy(before) - energy(after)) / ((conjugate - before) ** 3 / (4 * before * conjugate)) - 1, 0.05)
    check.norm(f"{name}: standard deviation of the place of the jump in {time[-1] - start:.0f} s, over the depth before it",
               float(toes.std()) / before, 1.0, "", 2)
    check.norm(f"{name}: place of the jump", place, None, "m", 2)
    behind = (x > begin) & (x < end)
    check.norm(f"{name}: how much higher the surface stands than the water's own depth", float(mean[behind].mean() / after - 1))
    exact = backwater(study, case, 0.0, "--discharge", f"{q} m2/s", "--upstream", "20mm", "--downstream", f"{tailwater}mm", "--length", str(length), "--stations", "1001")
    figures.exact(axes, x, exact(x), "riffle backwater" if froude == 3 else None)
    figures.simulated(axes, x, mean, f"Fr {froude} at the inflow", colour, most=200)
    if froude == 3:
        check.best, check.cost = options_text(flow), flow.cost_text
        account(check, flow)


def jump(study):
    check = Check("open_jump", "Hydraulic jumps",
                  "The depth of the water behind the jump, without the gaps in it, against the one whose momentum function is that of the water before it (Bélanger), where the particles' jump stands.")
    figure = figures.Figure(1, width=7)
    axes = figure.panel("distance along the channel x (m)", "level (m)", "mean from 5 s on")
    for number, froude in enumerate([3] if study.quick else JUMPS):
        _one_jump(study, check, froude, axes, figures.COLOURS[number])
    check.figures.append((figure.svg(check.name), "Mean level along the channel; the jump of the theory has no length."))
    return check


def _wall_shear(flow, start, rows=4, wide=2):
    """du/dz at the bed in columns `wide` spacings wide: u = a z + b z^2 through the particles of some rows."""
    columns = round(flow.length / (wide * flow.spacing))
    matrix, right = numpy.zeros((columns, 2, 2)), numpy.zeros((columns, 2))
    for s in flow.snapshots():
        if s.time < start:
            continue
        near = (s.z < rows * flow.spacing) & (s.x > 0) & (s.x < flow.length)
        column = numpy.clip((s.x[near] / (wide * flow.spacing)).astype(int), 0, columns - 1)
        powers = [s.z[near], s.z[near] ** 2]
        for i in range(2):
            right[:, i] += numpy.bincount(column, powers[i] * s.u[near], columns)
            for j in range(2):
                matrix[:, i, j] += numpy.bincount(column, powers[i] * powers[j], columns)
    filled = numpy.abs(numpy.linalg.det(matrix)) > 0
    x = (numpy.arange(columns) + 0.5) * wide * flow.spacing
    return x[filled], numpy.linalg.solve(matrix[filled], right[filled][:, :, None])[:, 0, 0]


def step(study):
    case = "cases/open-ends/backward-facing-step.toml"
    check = Check("open_step", "Backward-facing step",
                  "Laminar flow through a duct that doubles its height: how far behind the step the water comes back to the wall, against Erturk (2008).")
    figure = figures.Figure(1, width=7)
    axes = figure.panel("distance behind the step, in its heights", "du/dz at the wall, over U/h", "")
    for number, reynolds in enumerate([200] if study.quick else STEPS):
        length, viscosity, until = STEPS[reynolds]
        flow = study.run(f"open_step_{reynolds}", case, {} if reynolds == 200 else {
            "fluid.kinematic_viscosity": f'"{viscosity} m2/s"', "run.until": f'"{until} s"', "run.average_from": f'"{until - 3} s"'})
        corner, height = max(flow.parameters["solid"][0]["x"]), max(flow.parameters["solid"][0]["z"])
        x, shear = _wall_shear(flow, until - 3.0)
        behind = (x - corner) / height
        back = numpy.flatnonzero((shear < 0) & (behind > 0.5) & (behind < 15))[-1]
        place = float(numpy.interp(0.0, shear[back:back + 2], behind[back:back + 2]))
        check.norm(f"Re {reynolds}: length behind the step ({place:.2f} of its heights) against {length}", place / length - 1, 0.03)
        shown = behind > 0
        velocity = flow.parameters["inflow"]["unit_discharge"] / (flow.depth - height)
        figures.exact(axes, [length], [0], "Erturk (2008)" if number == 0 else None, figures.COLOURS[number], marker="o", linestyle="none")
        figures.simulated(axes, behind[shown], shear[shown] * height / velocity, f"Re {reynolds}", figures.COLOURS[number], most=200)
        if reynolds == 200:
            check.best, check.cost = options_text(flow), flow.cost_text
            account(check, flow)
    check.figures.append((figure.svg(check.name), "Shear at the wall behind the step; where it is zero the water comes back to the wall."))
    return check


CHECKS = {"open_jump": jump, "open_step": step}
