"""Bodies in a stream: forces of the water, pressures on the surface, the rhythm of the wake."""

import math
import warnings

import h5py
import numpy

import figures
from check import Check
from open_end_checks import account
from options import options_text

# Schaefer & Turek (1996), test cases 2D-1 and 2D-2: the middle of the intervals that they give.
STEADY = {"drag": 5.58, "lift": 0.0107, "pressure": 0.1174}
SHEDDING = {"drag": 3.23, "lift": 1.00, "strouhal": 0.300}


def _forces(flow, start, velocity, area, names=("solid_force_1", "solid_form_drag_1", "solid_lift_1")):
    """Time and the coefficients of drag, form drag and lift, or of other forces, of the first solid from `start` on; `area`: per width in a plane."""
    head = 0.5 * flow.density * velocity**2 * area
    with h5py.File(flow.folder / "results.h5", "r") as file:
        group = file["/probes/standard_force"]
        time = group["time"][:]
        late = time >= start
        return [time[late]] + [group[name][:][late] / head for name in names]


def _harmonic(time, value, frequency):
    """Amplitude of a record at a frequency, by least squares with its mean."""
    phase = 2 * math.pi * frequency * time
    matrix = numpy.column_stack([numpy.cos(phase), numpy.sin(phase), numpy.ones_like(phase)])
    return math.hypot(*numpy.linalg.lstsq(matrix, value, rcond=None)[0][:2])


def _gauges(flow, start):
    with h5py.File(flow.folder / "results.h5", "r") as file:
        group = file["/probes/pressure"]
        return group["pressure"][:][group["time"][:] >= start].mean(axis=0)


def _budget(study, flow):
    """What the momentum budget of `riffle analyse` leaves open, over what passes from the ends to the forces."""
    return study.findings(flow, "--chapter", "forces")["momentum_residual_share"]


def cylinder(study):
    check = Check("cylinder", "Cylinder in a duct",
                  "Laminar flow past a cylinder between two walls against Schäfer &amp; Turek (1996), Re of the mean velocity and the diameter: "
                  "at 20 steady (2D-1), at 100 a vortex street (2D-2). Sound swings the forces about these values.")
    diameter = 0.1
    steady = "cases/solids/cylinder.toml"
    for spacing in [None] if study.quick else [None, "10 mm"]:
        flow = study.run("cylinder_re20" + ("" if spacing is None else "_" + spacing[:2].strip()), steady, {} if spacing is None else {"numerics.spacing": f'"{spacing}"'})
        time, drag, form, lift = _forces(flow, 6.0, 0.2, diameter)
        pressure = _gauges(flow, 6.0)
        name = f"Re 20, {diameter / flow.spacing:.0f} spacings across"
        bar = 0.03 if spacing is None else None
        check.norm(f"{name}: drag coefficient against {STEADY['drag']}", drag.mean() / STEADY["drag"] - 1, bar)
        check.norm(f"{name}: form drag over the drag", form.mean() / drag.mean(), None, "", 3)
        check.norm(f"{name}: lift coefficient, {STEADY['lift']} there", lift.mean(), None, "", 2)
        check.norm(f"{name}: pressure before less that behind the cylinder, by gauges on it, against {STEADY['pressure']}",
                   (pressure[0] - pressure[1]) / flow.density / STEADY["pressure"] - 1)
        check.norm(f"{name}: standard deviation of the drag, by sound", drag.std() / drag.mean())
        if spacing is None:
            check.norm(f"{name}: momentum between the ends that the budget leaves open", _budget(study, flow), 0.01)
            check.best, check.cost = options_text(flow), flow.cost_text
        account(check, flow)
    if study.quick:
        return check
    flow = study.run("cylinder_re100", "cases/solids/cylinder-re100.toml")
    time, drag, form, lift = _forces(flow, 4.0, 1.0, diameter)
    frequencies = numpy.arange(2.7, 3.3, 0.001)
    frequency = frequencies[numpy.argmax([_harmonic(time, lift, f) for f in frequencies])]
    largest = drag.mean() + _harmonic(time, drag, 2 * frequency)
    name = f"Re 100, {diameter / flow.spacing:.0f} spacings across"
    check.norm(f"{name}: largest drag coefficient, mean and second harmonic, against {SHEDDING['drag']}", largest / SHEDDING["drag"] - 1, 0.03)
    check.norm(f"{name}: Strouhal number against {SHEDDING['strouhal']}", frequency * diameter / SHEDDING["strouhal"] - 1, 0.03)
    check.norm(f"{name}: largest lift coefficient, first harmonic, against {SHEDDING['lift']:.2f}", _harmonic(time, lift, frequency) / SHEDDING["lift"] - 1)
    check.norm(f"{name}: form drag over the drag", form.mean() / drag.mean(), None, "", 3)
    check.norm(f"{name}: momentum between the ends that the budget leaves open", _budget(study, flow), 0.02)
    figure = figures.Figure(2, width=8)
    # Means over a tenth of a period, which leave the sound out.
    width = max(1, round(0.033 / (time[1] - time[0])))
    middle = time[:time.size - width + 1] + 0.5 * width * (time[1] - time[0])
    for record, label, title in ((drag, "drag", "Re 100"), (lift, "lift", "")):
        axes = figure.panel("time (s)", f"{label} coefficient", title)
        figures.simulated(axes, middle, numpy.convolve(record, numpy.ones(width) / width, "valid"), "running mean", most=400)
        figures.exact(axes, [4, 8], [SHEDDING[label]] * 2, "largest, Schäfer & Turek (1996)")
    check.figures.append((figure.svg(check.name), "Forces on the cylinder at Re 100, running means over a tenth of a period."))
    return check


def sphere(study):
    check = Check("sphere", "Sphere in a stream",
                  "Laminar flow past a sphere, ten spacings across, in the middle of a duct six diameters wide and high with frictionless walls, against the drag of a "
                  "sphere in an unbounded stream (Clift, Grace &amp; Weber 1978). The walls of the duct add about what the stream between them is faster.")
    diameter, velocity = 0.1, 0.2
    for reynolds, case, start in ((20, "cases/solids/sphere-re20.toml", 2.0), (100, "cases/solids/sphere-re100.toml", 3.0)):
        flow = study.run(f"sphere_re{reynolds}", case)
        _, drag, form, lift, side = _forces(flow, start, velocity, math.pi / 4 * diameter**2,
                                            ("solid_force_1", "solid_form_drag_1", "solid_lift_1", "solid_side_force_1"))
        theory = 24 / reynolds * (1 + 0.1935 * reynolds**0.6305)
        name = f"Re {reynolds}"
        check.norm(f"{name}: drag coefficient against {theory:.3f}", drag.mean() / theory - 1, 0.05)
        check.norm(f"{name}: form drag over the drag", form.mean() / drag.mean(), None, "", 3)
        check.norm(f"{name}: force across the stream over the drag", math.hypot(lift.mean(), side.mean()) / drag.mean())
        check.norm(f"{name}: standard deviation of the drag, by sound", drag.std() / drag.mean())
        check.norm(f"{name}: momentum between the ends that the budget leaves open", _budget(study, flow), 0.02)
        check.best, check.cost = options_text(flow), flow.cost_text
        account(check, flow)
    return check


def pier(study):
    check = Check("bridge_pier", "Bridge pier in a stream",
                  "A discharge of 60 l/s per metre, 120 mm deep, over k_s = 1 mm past a row of round piers, 80 mm thick and six diameters apart, ten spacings across. "
                  "The water that meets the pier at the surface rises by its velocity's height, dives down the front (0.3 to 0.4 U at an upright cylinder: Raudkivi 1986), and winds around the foot.")
    flow = study.run("bridge_pier", "cases/open-ends/bridge-pier.toml")
    diameter, middle, front = 0.08, 0.24, 0.28
    with h5py.File(flow.folder / "results.h5", "r") as file:
        surface, mean = file["/surface_map"], file["/mean_field"]
        x, y = surface["x"][:], surface["y"][:]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)  # places inside of the pier have no surface
            level = numpy.nanmean(surface["elevation"][:][surface["time"][:] > 4.0], axis=0)[numpy.argmin(abs(y - middle))]
        late = mean["time"][:] > 4.0
        at, across, z = mean["x"][:], mean["y"][:], mean["z"][:]
        u, w = (numpy.mean(mean[name][:][late], axis=0)[:, numpy.argmin(abs(across - middle))] for name in ("velocity", "vertical_velocity"))
    before = numpy.argmin(abs(at - 0.08))
    profile = u[:, before][numpy.isfinite(u[:, before])]
    bulk = profile.mean()
    stagnation = profile[-2] ** 2 / (2 * flow.gravity_z)
    approach = x < front
    wave = numpy.nanmax(level[approach]) - numpy.interp(0.08, x, level)
    beside = (at > front - diameter / 4) & (at < front)
    down = -numpy.nanmin(w[:, beside])
    foot = numpy.nanmin(u[0, (at > front - diameter) & (at < front)])
    check.norm("bow wave before the pier against the height of the surface's velocity 2.5 diameters before it", wave / stagnation - 1, 0.1)
    check.norm("water that dives down the front, largest velocity of the mean flow over U", down / bulk, None, "", 2)
    check.norm("least velocity along the bed before the foot over U (below 0 in a horseshoe vortex)", foot / bulk, None, "", 2)
    velocity = 0.06 / numpy.interp(0.08, x, level)
    _, drag, form = _forces(flow, 4.0, velocity, diameter * flow.depth, ("solid_force_1", "solid_form_drag_1"))
    check.norm("drag coefficient, with the velocity of the stream and the depth at the outflow", drag.mean(), None, "", 2)
    check.norm("the same with the velocity between the piers", drag.mean() * (1 - diameter / 0.48) ** 2, None, "", 2)
    check.norm("form drag over the drag", form.mean() / drag.mean(), None, "", 3)
    check.norm("momentum between the ends that the budget leaves open", _budget(study, flow), 0.02)
    figure = figures.Figure(2, width=8)
    axes = figure.panel("x (mm)", "level (mm)", "surface, in the middle plane")
    figures.simulated(axes, 1e3 * x, 1e3 * level, "particles")
    figures.exact(axes, [80, 1e3 * front], [1e3 * (numpy.interp(0.08, x, level) + stagnation)] * 2, "stagnation height")
    axes = figure.panel("w (m/s)", "z (mm)", "before the front")
    figures.simulated(axes, numpy.nanmin(w[:, beside], axis=1), 1e3 * z, "particles, within D/4")
    check.figures.append((figure.svg(check.name), "The surface along the plane through the pier, and the velocity that dives down its front."))
    check.best, check.cost = options_text(flow), flow.cost_text
    account(check, flow)
    return check


def horseshoe(study):
    check = Check("horseshoe_vortex", "Horseshoe vortex before a pier",
                  "Laminar water, Re = 600 by the pier's 80 mm, 20 spacings across, with the velocity of a film over the bed, meets a round pier. What the pressure before the front "
                  "drives down it flows back along the bed, parts it before the foot and rolls up. In the plane of symmetry, mean from 3 s on.")
    flow = study.run("horseshoe_vortex", "cases/open-ends/horseshoe-vortex.toml")
    begin = flow.parameters["run"]["average_from"]
    diameter, middle, front, velocity = 0.08, 0.16, 0.18, 0.15
    edges = numpy.arange(0.06, front + 1e-9, flow.spacing), numpy.arange(0, 0.08 + 1e-9, flow.spacing)
    sums = numpy.zeros((3, len(edges[0]) - 1, len(edges[1]) - 1))
    legs = []
    for s in flow.snapshots():
        if s.time < begin:
            continue
        near = s.y > middle - 2 * flow.spacing
        for k, weights in enumerate((None, s.u[near], s.w[near])):
            sums[k] += numpy.histogram2d(s.x[near], s.z[near], bins=edges, weights=weights)[0]
        # Beside the pier, where the vortex goes by: the water over the bed against that above, across the stream.
        beside = (abs(s.x - 0.22) < 0.02) & (s.y < middle - diameter / 2) & (s.y > middle - diameter)
        low = s.z < 2 * flow.spacing
        legs.append(s.v[beside & low].mean() - s.v[beside & (s.z > 4 * flow.spacing) & (s.z < 8 * flow.spacing)].mean())
    u, w = sums[1] / sums[0], sums[2] / sums[0]
    x, z = (0.5 * (e[:-1] + e[1:]) for e in edges)
    bed = u[:, 0]
    before = x > front - diameter / 2
    check.norm("share of the bed within half a diameter before the foot where the water does not flow back", float((bed[before] >= 0).mean()), 0.1)
    # In the corner itself a second, smaller one may turn the other way.
    parts = x[numpy.flatnonzero((bed >= 0) & (x < front - diameter / 8))[-1]]
    check.norm("where the flow along the bed parts, before the front, over the diameter", float((front - parts) / diameter), None, "", 2)
    check.norm("fastest water along the bed against the stream, over U", float(-bed.min() / velocity), None, "", 2)
    inner = u[before & (x < front - diameter / 8)][:, z < diameter / 2]
    back = max(z[:inner.shape[1]][row < 0].max() for row in inner if (row < 0).any()) + flow.spacing / 2
    check.norm("height up to which it flows back, at most, over the diameter", float(back / diameter), None, "", 2)
    close = x > front - diameter / 4
    check.norm("water that dives down the front, largest velocity over U", float(-w[close].min() / velocity), None, "", 2)
    check.norm("beside the pier, velocity outwards along the bed less that above, over U", float(-numpy.mean(legs) / velocity), None, "", 2)
    drag = _forces(flow, begin, velocity, diameter / 2 * flow.depth)[1]
    check.norm("drag coefficient, with U and the depth", drag.mean(), None, "", 2)
    check.norm("momentum between the ends that the budget leaves open", _budget(study, flow), 0.02)
    figure = figures.Figure(2, width=10)
    axes = figure.panel("x (mm)", "z (mm)", "plane of symmetry, before the front")
    axes.quiver(1e3 * x, 1e3 * z[:10], u.T[:10], w.T[:10], numpy.hypot(u, w).T[:10], cmap="viridis", scale=1.6, width=0.003)
    axes.set_aspect("equal")
    axes = figure.panel("x (mm)", "u (m/s)", "along the bed, lowest spacing")
    figures.simulated(axes, 1e3 * x, bed, "particles")
    axes.axhline(0, color="#222222", lw=0.8)
    check.figures.append((figure.svg(check.name), "The water before the foot of the pier, whose front stands at 180 mm, and its velocity along the bed."))
    check.best, check.cost = options_text(flow), flow.cost_text
    account(check, flow)
    return check


CHECKS = {"cylinder": cylinder, "sphere": sphere, "bridge_pier": pier, "horseshoe_vortex": horseshoe}
