"""Water that parts from a step."""

import numpy

import figures
from check import Check
from open_end_checks import account
from options import options_text

# Length behind the step, in its heights, by the Reynolds number of the mean velocity and twice the height of the inflow (Erturk 2008):
# viscosity (m2/s), until (s).
STEPS = {100: (2.922, 2e-5, 8), 200: (4.982, 1e-5, 12), 300: (6.751, 6.6667e-6, 16), 400: (8.237, 5e-6, 20)}


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
        account(check, flow)
        if reynolds == 200:
            check.best, check.cost = options_text(flow), flow.cost_text
    check.figures.append((figure.svg(check.name), "Shear at the wall behind the step; where it is zero the water comes back to the wall."))
    return check


CHECKS = {"open_step": step}
