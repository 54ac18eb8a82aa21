"""Floods and tides: flow that changes along a flume, against unsteady flow in one dimension."""

import csv
import json

import h5py
import numpy

import figures
from check import Check
from open_end_checks import account, column_profile, program
from options import options_text
from runs import ROOT
from shallow_water import saint_venant


def uniform_rating(study, case, depths):
    """Discharge of a unit of the width of the uniform flow over the bed of a case at some depths (m), and the momentum coefficient of the first."""
    bed = study.folder / "bed.toml"
    text = (ROOT / case).read_text()
    begin, end = text.index("[inflow]"), text.index("[bed]")
    plain = text[:begin] + text[end:text.index("[[probe]]")]
    bed.write_text(plain.replace('ends = "open"', 'ends = "periodic"').replace('kind = "backwater"', 'kind = "column"'))
    of = [(bed, "--set", f"channel.depth={depth}") for depth in depths]
    discharge = [depth * json.loads(program(study, "column", *arguments, "--json"))["depth_mean_velocity"] for depth, arguments in zip(depths, of)]
    z, u = column_profile(study, *of[0])
    faces = numpy.concatenate(([0.0], 0.5 * (z[1:] + z[:-1]), [depths[0]]))
    share = numpy.diff(faces) / depths[0]
    return numpy.array(discharge), float((share * u**2).sum() / (share * u).sum() ** 2)


def smooth(values, width):
    """Running mean over an odd number of values, as many at both ends."""
    return numpy.convolve(numpy.pad(values, (width // 2, width // 2), "edge"), numpy.ones(width) / width, "valid")


def _two_columns(case):
    """The columns of the CSV file that lies beside a case under its name."""
    with open((ROOT / case).with_suffix(".csv"), encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return numpy.array([[float(value) for value in row.values()] for row in rows]).T


def _sections(flow):
    """Places, times, and the running means over 0.42 s of depth and discharge [place, time] of the probe "sections"."""
    with h5py.File(flow.folder / "results.h5", "r") as file:
        probe = file["/probes/sections"]
        h, q = (numpy.array([smooth(column, 21) for column in probe[name][:].T]) for name in ("depth", "flow_rate"))
        return probe["x"][:], probe["time"][:], h, q


def _power_rating(depths, discharge):
    """Discharge of uniform flow at a depth, by power laws between those of a table."""
    return lambda h: numpy.exp(numpy.interp(numpy.log(h), numpy.log(depths), numpy.log(discharge)))


def hydrograph(study):
    case = "cases/open-ends/hydrograph.toml"
    check = Check("open_hydrograph", "A flood passes a flume",
                  "A flood of more than twice the discharge runs down 8 m of a bed of 2 mm of equivalent roughness, against the equations of de Saint-Venant with the friction "
                  "of the column twin, 400 cells: the hydrograph upstream, and at 7.5 m the depth of the run.")
    flow = study.run("open_hydrograph", case)
    depths = numpy.geomspace(0.05, 0.13, 8)
    discharge, beta = uniform_rating(study, case, depths)
    rating = _power_rating(depths, discharge)
    given = _two_columns(case)
    entering = lambda t: numpy.interp(t, given[0], given[1])
    x, time, h, q = _sections(flow)
    slope, gravity = numpy.sin(numpy.arctan(flow.parameters["channel"]["slope"])), 9.81
    first = float(numpy.exp(numpy.interp(numpy.log(entering(0.0)), numpy.log(discharge), numpy.log(depths))))
    solve = lambda length, depth, cells: saint_venant(
        length, slope, gravity, lambda h, q: slope * (q / rating(h)) ** 2, entering, depth,
        (lambda x: numpy.full_like(x, first), lambda x: numpy.full_like(x, entering(0.0))), time[-1], cells, beta)
    moments, places, exact_h, exact_q = solve(x[-1], lambda t: float(numpy.interp(t, time, h[-1])), 400)
    # So far that nothing of its end is felt.
    _, long_places, long_h, _ = solve(40.0, lambda t: first, 1000)
    rise = given[1].max() - given[1].min()
    figure = figures.Figure(3)
    axes = [figure.panel("time (s)", "discharge (m2/s)", "at three sections"), figure.panel("time (s)", "depth (mm)", "at three sections"),
            figure.panel("discharge (m2/s)", "depth (mm)", f"loop of the rating at {x[1]:g} m")]
    for n, place in enumerate(x[:-1]):
        at = numpy.abs(places - place).argmin()
        qs, hs = (numpy.interp(time, moments, values[:, at]) for values in (exact_q, exact_h))
        check.norm(f"discharge at {place:g} m, rms over the rise of the flood", float(numpy.sqrt(numpy.mean((q[n] - qs) ** 2)) / rise), 0.01)
        check.norm(f"depth at {place:g} m, largest departure", float(numpy.abs(h[n] / hs - 1).max()), 0.01)
        check.norm(f"largest discharge at {place:g} m", float(q[n].max() / qs.max() - 1), 0.01)
        # The running mean over 0.42 s knows the time of a crest to half of that.
        check.norm(f"when it passes {place:g} m, {time[qs.argmax()] - given[0][given[1].argmax()]:.2f} s after it came in", float(time[q[n].argmax()] - time[qs.argmax()]), 0.21, "s")
        colour = figures.COLOURS[n]
        for panel, run, reference in ((axes[0], q[n], qs), (axes[1], 1e3 * h[n], 1e3 * hs)):
            figures.exact(panel, time, reference, f"de Saint-Venant, {place:g} m", colour)
            figures.simulated(panel, time, run, f"{place:g} m", colour, most=60)
        if n == 1:
            figures.exact(axes[2], qs, 1e3 * hs, "de Saint-Venant", colour)
            figures.simulated(axes[2], q[n], 1e3 * h[n], "particles", colour, most=90)
            height = numpy.linspace(hs.min(), hs.max(), 50)
            figures.exact(axes[2], rating(height), 1e3 * height, "uniform flow", figures.COLOURS[3])
            loop = [numpy.interp(0.05, run[: run.argmax()], level[: run.argmax()]) for run, level in ((q[n], h[n]), (qs, hs))]
            back = [numpy.interp(0.05, run[run.argmax():][::-1], level[run.argmax():][::-1]) for run, level in ((q[n], h[n]), (qs, hs))]
            check.norm(f"depth at {place:g} m that 0.05 m2/s has when the flood falls less that when it rises, {1e3 * (back[1] - loop[1]):.1f} mm", float((back[0] - loop[0]) / (back[1] - loop[1]) - 1), 0.1)
    check.norm("highest discharge: loss of the crest over 6 m, share of the rise", float((given[1].max() - q[2].max()) / rise))
    for n, place in enumerate(x):
        check.norm(f"highest depth at {place:g} m against that in a channel of 40 m", float(h[n].max() / long_h[:, numpy.abs(long_places - place).argmin()].max() - 1))
    account(check, flow)
    check.figures.append((figure.svg(check.name), "Discharge and depth as the flood passes, and the loop that they make: for one discharge the water stands higher when the flood falls than when it rises."))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


def _steady_depths(length, slope, gravity, friction_slope, discharge, depth, beta, cells=400):
    """Depth of steady varied flow on the places of saint_venant(), from that at the downstream end on (midpoint rule)."""
    rise = lambda h: (slope - friction_slope(h, discharge)) / (1.0 - beta * discharge**2 / (gravity * h**3))
    h = numpy.full(cells + 1, depth)
    dx = length / cells
    for i in range(cells, 0, -1):
        h[i - 1] = h[i] - dx * rise(h[i] - 0.5 * dx * rise(h[i]))
    return h


def tide(study):
    case = "cases/open-ends/tide.toml"
    check = Check("open_tide", "A tide against a river",
                  "The depth at the end of a channel of 6 m rises and falls by 16 mm every minute against a constant discharge, which turns: against the equations of de "
                  "Saint-Venant with the friction of the column twin, 400 cells, the discharge upstream and the depth of the file at the outflow.")
    flow = study.run("open_tide", case)
    depths = numpy.geomspace(0.05, 0.12, 8)
    discharge, beta = uniform_rating(study, case, depths)
    rating = _power_rating(depths, discharge)
    given = _two_columns(case) * [[1.0], [1e-3]]
    x, time, h, q = _sections(flow)
    slope, gravity, length = numpy.sin(numpy.arctan(flow.parameters["channel"]["slope"])), 9.81, flow.length
    entering = flow.parameters["inflow"]["unit_discharge"]
    friction = lambda h, q: slope * q * numpy.abs(q) / rating(h) ** 2
    start = _steady_depths(length, slope, gravity, friction, entering, given[1][0], beta)
    moments, places, exact_h, exact_q = saint_venant(
        length, slope, gravity, friction, lambda t: entering, lambda t: float(numpy.interp(t, *given)),
        (lambda x: start.copy(), lambda x: numpy.full_like(x, entering)), time[-1], 400, beta)
    late = time > given[0][given[1].argmax()]
    at = lambda place: numpy.abs(places - place).argmin()
    series = lambda values, place: numpy.interp(time, moments, values[:, at(place)])
    range_of = lambda values: float(values.max() - values.min())
    tide_range, flow_range = range_of(given[1]), range_of(series(exact_q, x[-1])[late])
    figure = figures.Figure(2)
    places_text = f"at {', '.join(f'{place:g}' for place in x)} m (blue to violet)"
    axes = [figure.panel("time (s)", "discharge (m2/s)", places_text), figure.panel("time (s)", "depth (mm)", places_text)]
    for n, place in enumerate(x):
        qs, hs = series(exact_q, place), series(exact_h, place)
        check.norm(f"discharge at {place:g} m, rms over its range at {x[-1]:g} m", float(numpy.sqrt(numpy.mean((q[n] - qs)[late] ** 2)) / flow_range), 0.03)
        check.norm(f"depth at {place:g} m, rms over the range of the tide", float(numpy.sqrt(numpy.mean((h[n] - hs)[late] ** 2)) / tide_range), 0.03)
        check.norm(f"range of the depth at {place:g} m, {range_of(hs[late]) / tide_range:.2f} of the tide's", float(range_of(h[n][late]) / range_of(hs[late]) - 1), 0.03)
        colour = figures.COLOURS[n]
        for panel, run, reference in ((axes[0], q[n], qs), (axes[1], 1e3 * h[n], 1e3 * hs)):
            figures.exact(panel, time, reference, None if n else "de Saint-Venant", colour)
            figures.simulated(panel, time, run, None if n else "particles", colour, most=60)
    turned = [float(numpy.mean(values[late] < 0.0)) for values in (q[-1], series(exact_q, x[-1]))]
    check.norm(f"share of the time in which water goes up the channel at {x[-1]:g} m, {turned[1]:.3f}, less that", turned[0] - turned[1], 0.02, "", 3)
    account(check, flow)
    check.figures.append((figure.svg(check.name), "Discharge and depth under a tide: the river turns near its mouth, and stands higher at its head than the tide."))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


def _coming_flood(flow, place, until):
    """Depth and discharge at a section of the standard ones up to a time, running means over 0.09 s, and those of the equations of de Saint-Venant
    without friction between the discharge that enters the run and the depth that leaves it: time, depth, discharge, depth and discharge of the equations."""
    with h5py.File(flow.folder / "results.h5", "r") as file:
        sections, ends = file["/probes/standard_flow_rate"], file["/probes/standard_end_sections"]
        time, number = sections["time"][:], int(numpy.abs(sections["x"][:] - place).argmin())
        h, q = (smooth(sections[name][:, number], 9) for name in ("depth", "flow_rate"))
        moments, leaving = ends["time"][:], smooth(ends["depth"][:, -1], 9)
    entering = smooth(flow.series["inflow_discharge"], 9)
    steps, places, exact_h, exact_q = saint_venant(
        flow.length, 0.0, flow.gravity_z, lambda h, q: 0.0 * q, lambda t: float(numpy.interp(t, flow.series["time"], entering)),
        lambda t: float(numpy.interp(t, moments, leaving)), (lambda x: numpy.full_like(x, flow.depth), numpy.zeros_like), until, 800)
    at = int(numpy.abs(places - place).argmin())
    early = time < until
    return (time[early], h[early], q[early], *(numpy.interp(time[early], steps, values[:, at]) for values in (exact_h, exact_q)))


def deck(study):
    case = "cases/open-ends/flood-on-deck.toml"
    check = Check("open_deck", "Flood wave against a bridge deck",
                  "A flood of four times the discharge comes down a channel without friction and meets a deck over the still water. On its way, 0.6 m before the deck, against the equations of "
                  "de Saint-Venant until what the deck throws back comes there; at the deck, the force on it against the momentum that is lost between the ends.")
    flow = study.run("open_deck", case)
    front = min(flow.parameters["solid"][0]["x"])
    felt = 2.3  # s: the water is at the lower face at 1.9 s, and the deck is felt upstream at u - c
    time, h, q, exact_h, exact_q = _coming_flood(flow, 0.5 * front, felt)
    for name, run, reference in (("depth", h, exact_h), ("discharge", q, exact_q)):
        check.norm(f"{name} 0.6 m before the deck until {felt:g} s, rms over its rise", float(numpy.sqrt(numpy.mean((run - reference) ** 2)) / (reference.max() - reference[0])), 0.05)
    found = study.findings(flow, "--chapter", "forces", "--window", "2,5")
    check.norm("momentum between the ends that the budget leaves open, 2 to 5 s", found["momentum_residual_share"], 0.02)
    with h5py.File(flow.folder / "results.h5", "r") as file:
        probe = file["/probes/forces"]
        moments, drag, lift = (probe[name][:] for name in ("time", "solid_force_1", "solid_lift_1"))
    check.norm("largest force on the deck in the first second and a half, which is dry", float(numpy.hypot(drag, lift)[moments < 1.5].max()), 0.0, "N/m")
    steady = study.findings(flow, "--chapter", "forces", "--window", "2.5,4.5")
    check.norm("drag coefficient of the deck under the flood, 2.5 to 4.5 s, with the velocity of the stream and the wet height of the deck", steady["drag_coefficient_1"], unit="", digits=2)
    slow = lambda values: smooth(values, 101)  # 50 ms
    check.norm("largest force along the channel, mean over 50 ms", float(slow(drag).max()), unit="N/m", digits=3)
    check.norm("largest lift, mean over 50 ms", float(slow(lift).max()), unit="N/m", digits=3)
    account(check, flow)
    figure = figures.Figure(2)
    axes = figure.panel("time (s)", "depth (mm), discharge (l/s per m)", "0.6 m before the deck")
    for run, reference, name, colour in ((h, exact_h, "depth", figures.COLOURS[0]), (q, exact_q, "discharge", figures.COLOURS[1])):
        figures.exact(axes, time, 1e3 * reference, f"{name}, de Saint-Venant", colour)
        figures.simulated(axes, time, 1e3 * run, name, colour, most=60)
    axes = figure.panel("time (s)", "force on the deck (N/m)", "means over 50 ms")
    for values, name, colour in ((drag, "along the channel", figures.COLOURS[0]), (lift, "upward", figures.COLOURS[1])):
        figures.exact(axes, moments, slow(values), name, colour)
    check.figures.append((figure.svg(check.name), "The flood on its way to the deck, and the force on it."))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


CHECKS = {"open_hydrograph": hydrograph, "open_tide": tide, "open_deck": deck}
