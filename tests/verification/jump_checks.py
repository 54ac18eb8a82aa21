"""Hydraulic jumps: with a roller, and undular."""

import math

import numpy

import figures
from check import Check
from open_end_checks import account, backwater, depth_by_area, surface_of
from options import options_text

# Froude number at the inflow, 20 mm deep: unit discharge (m2/s), depth that is held at the end (mm), length (m), until and from (s), spacing (mm).
JUMPS = {3: (0.02658, 70, 1.0, 25, 5, 2), 2.3: (0.02038, 52.5, 0.8, 15, 5, 2), 4: (0.03544, 97, 1.5, 32, 12, 2), 6: (0.05315, 146, 2.0, 11, 5, 2.5)}
# What else some of them need. At Fr 4 the outflow's default, ten seconds, would let the jump wander as long; at Fr 6 so many gaps open in the
# roller that the surface behind it stands a tenth higher than the water's own depth.
FURTHER_SETTINGS = {4: {"outflow.relaxation_time": '"1 s"'}, 6: {"numerics.density_relaxation": "0.4"}}


def _roller(check, name, flow, q, start, begin=0.0):
    """Rows about a jump with a roller between what enters, or comes from a place `begin` on, and what leaves: the depth and the loss behind
    it, and whether it keeps its place. Places and the mean level there."""
    g = flow.gravity_z
    time, x, level = surface_of(flow)
    late = time > start
    mean = numpy.nanmean(level[late], axis=0)
    deep = mean[x > 0.9 * flow.length].mean()
    half = 0.5 * (mean[(x > begin) & (x < begin + 0.1 * flow.length)].mean() + deep)
    toes = numpy.array([x[numpy.argmax((row > half) & (x > begin))] for row in level[late]])
    place = float(numpy.median(toes))
    # Before the jump, as near to it as the water does not rise yet; behind it, as near as the roller ends.
    before = depth_by_area(flow, max(place - 1.5 * deep, begin + 0.05), 0.01, start)
    first_behind, last_behind = place + 4 * deep, 0.95 * flow.length
    after = depth_by_area(flow, 0.5 * (first_behind + last_behind), 0.5 * (last_behind - first_behind), start)
    local = q / before / math.sqrt(g * before)
    conjugate = 0.5 * before * (math.sqrt(1 + 8 * local**2) - 1)
    energy = lambda h: h + q**2 / (2 * g * h**2)
    check.norm(f"{name}: Froude number before the jump, {before / flow.spacing:.0f} rows deep", local, None, "", 3)
    check.norm(f"{name}: depth behind the jump against the conjugate one", after / conjugate - 1, 0.03)
    check.norm(f"{name}: loss of energy head against that of the conjugate depths",
               (energy(before) - energy(after)) / ((conjugate - before) ** 3 / (4 * before * conjugate)) - 1, 0.05)
    check.norm(f"{name}: standard deviation of the place of the jump in {time[-1] - start:.0f} s, over the depth before it",
               float(toes.std()) / before, 1.0, "", 2)
    halves = [part.mean() for part in numpy.array_split(toes, 2)]
    check.norm(f"{name}: mean place in the second half of this time against the first, over the depth before it",
               float(abs(halves[1] - halves[0])) / before, None, "", 2)
    check.norm(f"{name}: place of the jump", place, None, "m", 2)
    behind = (x > first_behind) & (x < last_behind)
    check.norm(f"{name}: how much higher the surface stands than the water's own depth", float(mean[behind].mean() / after - 1))
    return x, mean


def _one_jump(study, check, froude, axes, colour):
    case = "cases/open-ends/hydraulic-jump.toml"
    q, tailwater, length, until, start, spacing = JUMPS[froude]
    settings = {} if froude == 3 else {
        "inflow.unit_discharge": f'"{q} m2/s"', "channel.depth": f'"{tailwater} mm"', "outflow.depth": f'"{tailwater} mm"',
        "channel.length": f'"{length} m"', "run.until": f'"{until} s"'}
    settings |= FURTHER_SETTINGS.get(froude, {})
    if spacing != 2:
        settings |= {"numerics.spacing": f'"{spacing} mm"'}
    flow = study.run(f"open_jump_{froude}", case, settings)
    x, mean = _roller(check, f"Fr {froude} at the inflow", flow, q, start)
    exact = backwater(study, case, 0.0, "--discharge", f"{q} m2/s", "--upstream", "20mm", "--downstream", f"{tailwater}mm", "--length", str(length), "--stations", "1001")
    figures.exact(axes, x, exact(x), "riffle backwater" if froude == 3 else None)
    figures.simulated(axes, x, mean, f"Fr {froude} at the inflow, from {start} s on", colour, most=200)
    account(check, flow)
    if froude == 3:
        check.best, check.cost = options_text(flow), flow.cost_text


def jump(study):
    check = Check("open_jump", "Hydraulic jumps",
                  "The depth of the water behind the jump, without the gaps in it, against the one whose momentum function is that of the water before it (Bélanger), where the particles' jump stands.")
    figure = figures.Figure(1, width=7)
    axes = figure.panel("distance along the channel x (m)", "level (m)", "mean level")
    for number, froude in enumerate([3] if study.quick else JUMPS):
        _one_jump(study, check, froude, axes, figures.COLOURS[number])
    check.figures.append((figure.svg(check.name), "Mean level along the channel; the jump of the theory has no length."))
    return check


def wave_length(z, u, depth, gravity):
    """Length of a small wave that stands in a flow of the velocities u at the heights z: the longest solution of Rayleigh's equation in the
    form (U^2 f')' = k^2 U^2 f with f = 0 at the bed and U^2 f' = g f at the surface, w = U f, m."""
    cells = 400
    edges = numpy.linspace(0.0, depth, cells + 1)
    step = depth / cells
    at_edges, at_middles = numpy.interp(edges, z, u) ** 2, numpy.interp(0.5 * (edges[1:] + edges[:-1]), z, u) ** 2
    faces = at_edges / step**2
    diagonal = -faces[:-1] - faces[1:]
    diagonal[0] -= faces[0]  # half a cell to the bed
    diagonal[-1] += faces[-1] + gravity / step
    scale = 1.0 / numpy.sqrt(at_middles)
    matrix = numpy.diag(diagonal) + numpy.diag(faces[1:-1], 1) + numpy.diag(faces[1:-1], -1)
    return 2 * math.pi / math.sqrt(numpy.linalg.eigvalsh(matrix * scale * scale[:, None])[-1])


def _profile_between(flow, begin, end, start):
    """Mean velocity in rows of one spacing of the water between two places, as far as half of each row is wet."""
    rows = math.ceil(2.5 * flow.depth / flow.spacing)
    count, sums = numpy.zeros(rows), numpy.zeros(rows)
    for s in flow.snapshots():
        if s.time >= start:
            here = (s.x >= begin) & (s.x < end)
            row = (s.z[here] / flow.spacing).astype(int).clip(0, rows - 1)
            count += numpy.bincount(row, minlength=rows)
            sums += numpy.bincount(row, s.u[here], rows)
    wet = count > 0.5 * count.max()
    return (numpy.arange(rows)[wet] + 0.5) * flow.spacing, sums[wet] / count[wet]


def undular(study):
    case = "cases/open-ends/undular-jump.toml"
    check = Check("open_undular", "Undular jump",
                  "Water at 1.3 times the speed of its waves rises in a train of waves that stand: their mean level against steady varied flow, their lengths against small waves on the flow's own profile.")
    flow = study.run("open_undular", case)
    start, g = flow.parameters["run"]["average_from"], flow.gravity_z
    q, first, last = (flow.parameters[section][key] for section, key in
                      (("inflow", "unit_discharge"), ("inflow", "depth"), ("outflow", "depth")))
    time, x, level = surface_of(flow)
    late = time > start
    mean = numpy.nanmean(level[late], axis=0)
    tops = [i for i in range(5, len(x) - 5) if mean[i] == mean[i - 5:i + 6].max() and mean[i] > 1.2 * first]
    before = numpy.interp(0.2, x, mean)
    froude = q / before / math.sqrt(g * before)
    check.norm("Froude number before the jump", froude, None, "", 3)
    check.norm("first crest over the depth before it, against the solitary wave's Fr^2", float(mean[tops[0]] / before / froude**2 - 1))
    exact = backwater(study, case, 0.0, "--discharge", f"{q} m2/s", "--upstream", f"{1e3 * first:g}mm", "--downstream", f"{1e3 * last:g}mm",
                      "--length", str(flow.length), "--stations", "1001")
    figure = figures.Figure(2, width=10)
    axes = figure.panel("distance along the channel x (m)", "depth (m)", f"mean from {start:g} s on")
    figures.exact(axes, x, exact(x), "riffle backwater")
    figures.simulated(axes, x, mean, "particles", figures.COLOURS[0], most=400)
    lengths, small, depths, levels = [], [], [], []
    for left, right in zip(tops, tops[1:]):
        inside = (x >= x[left]) & (x < x[right])
        depths.append(float(mean[inside].mean()))
        levels.append(depths[-1] / float(exact(x[inside]).mean()) - 1)
        lengths.append(float(x[right] - x[left]))
        z, u = _profile_between(flow, x[left], x[right], start)
        small.append(wave_length(z, u, depths[-1], g))
    check.norm(f"mean level of the {len(lengths)} waves against riffle backwater, largest departure", float(numpy.abs(levels).max()), 0.03)
    check.norm("lengths of the waves against small waves on the profile below them, largest departure",
               float(numpy.abs(numpy.array(lengths) / small - 1).max()), 0.05)
    plug = [wave_length(numpy.array([0.0, 1.0]), numpy.full(2, q / h), h, g) for h in depths]
    check.norm("the same against small waves in water without shear", float(numpy.abs(numpy.array(lengths) / plug - 1).max()))
    crest = numpy.array([x[tops[0] - 20 + numpy.argmax(row[tops[0] - 20:tops[0] + 21])] for row in level[late]])
    check.norm(f"standard deviation of the place of the first crest in {time[-1] - start:.0f} s, over the depth before it", float(crest.std()) / before, 1.0, "", 2)
    axes = figure.panel("mean depth of a wave (m)", "length (m)", "crest to crest")
    figures.exact(axes, depths, small, "small waves on the flow's profile")
    figures.exact(axes, depths, plug, "small waves without shear", linestyle=":")
    figures.simulated(axes, depths, lengths, "particles", figures.COLOURS[0])
    check.figures.append((figure.svg(check.name), "Depth along the channel, and the lengths of the waves."))
    check.best, check.cost = options_text(flow), flow.cost_text
    account(check, flow)
    return check


def sluice_gate(study):
    case = "cases/open-ends/sluice-gate.toml"
    check = Check("open_gate", "Jump behind a sluice gate",
                  "The jet under a gate: its depth and discharge against those of the contraction 0.61, and the jump behind it, as above.")
    flow = study.run("open_gate", case)
    start, g = flow.parameters["run"]["average_from"], flow.gravity_z
    gate = flow.parameters["solid"][0]
    opening, behind = min(gate["z"]), max(gate["x"])
    q = float(flow.series["inflow_discharge"][flow.series["time"] > start].mean())
    pool = depth_by_area(flow, 0.5 * min(gate["x"]), 0.1, start)
    contraction = 0.61
    law = contraction * opening * math.sqrt(2 * g * pool / (1 + contraction * opening / pool))
    check.norm(f"discharge against that of a contraction of {contraction} for the depth of the pool", q / law - 1, 0.03)
    jet = float(depth_by_area(flow, behind + numpy.arange(0.5, 4, 0.5) * opening, 5 * flow.spacing, start).min())
    check.norm(f"depth of the jet, {opening / flow.spacing:.0f} rows in the opening, against {contraction} of the opening",
               jet / (contraction * opening) - 1, 0.05)
    x, mean = _roller(check, "jump", flow, q, start, behind + opening)
    figure = figures.Figure(1, width=8)
    axes = figure.panel("distance along the channel x (m)", "level (m)", f"mean from {start:g} s on")
    figures.simulated(axes, x, mean, "particles", figures.COLOURS[0], most=400)
    reach = (x > behind + opening) & (x < behind + 8 * opening)
    figures.exact(axes, x[reach], numpy.full(reach.sum(), contraction * opening), f"{contraction} of the opening", linestyle=":")
    axes.set_ylim(0, None)
    check.figures.append((figure.svg(check.name), "Mean level along the channel: pool, jet, the first wave of the jump, and its tail."))
    check.best, check.cost = options_text(flow), flow.cost_text
    account(check, flow)
    return check


CHECKS = {"open_jump": jump, "open_gate": sluice_gate, "open_undular": undular}
