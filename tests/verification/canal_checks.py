"""Canals, channels of a cross-section of their own, with open ends."""

import h5py
import numpy

import figures
from check import Check
from inflow_checks import files_across
from open_end_checks import account, backwater, mean_surface
from options import options_text

SHARES = (0.25, 0.5, 0.75)


def discharges(flow, start):
    """Mean discharges of the standard sections from a time on, m3/s, by their places, m."""
    with h5py.File(flow.folder / "results.h5", "r") as file:
        probe = file["/probes/standard_flow_rate"]
        late = probe["time"][:] > start
        return probe["x"][:], probe["flow_rate"][:][late].mean(axis=0)


def _canal(study, check, *settings):
    case = "cases/open-ends/canal.toml"
    flow = study.run(check.name, case, dict(setting.split("=", 1) for setting in settings))
    start = flow.parameters["run"]["average_from"]
    given = flow.parameters["inflow"]["discharge"]
    curve = backwater(study, case, 0.0, *(word for setting in settings for word in ("--set", setting)))
    figure = figures.Figure(3, width=10)
    axes = figure.panel("place along the canal x (m)", "depth (m)", f"mean from {start:g} s on")
    x, level = mean_surface(flow, start)
    figures.exact(axes, x, curve(x), "riffle backwater")
    figures.simulated(axes, x, level, "particles")
    check.norm("mean depth against that of riffle backwater, largest departure over the depth", float(numpy.abs(level / curve(x) - 1).max()), 0.02)
    check.norm("the same, mean over the length", float((level / curve(x) - 1).mean()), 0.01)
    for place, discharge in zip(*discharges(flow, start)):
        check.norm(f"discharge at {place:.2f} m over that of the inflow, less one", float(discharge / given - 1), 0.01)
    axes = figure.panel("place across the canal y (m)", "depth mean of u (m/s)", "")
    for number, share in enumerate(SHARES):
        y, u, count = files_across(flow, share * flow.length, 0.1 * flow.length, start, flow.parameters["channel"]["width"])
        if number == 0:
            first = u
        else:
            wet = numpy.isfinite(u) & numpy.isfinite(first)
            mean = numpy.average(first[wet], weights=count[wet])
            check.norm(f"U(y) at {share:.0%} of the length against that at 25 %, rms over the water, over its mean",
                       float(numpy.sqrt(numpy.average((u - first)[wet] ** 2, weights=count[wet])) / mean), 0.03)
        figures.simulated(axes, y, u, f"at {share:.0%} of the length", figures.COLOURS[number])
    time, level = flow.series["time"], flow.series["mean_level"]
    axes = figure.panel("time t (s)", "mean level (m)", "")
    figures.simulated(axes, time, level, "particles", most=400)
    check.norm("mean level, largest departure from its mean", float(numpy.abs(level[time > start] / level[time > start].mean() - 1).max()), 0.01)
    check.figures.append((figure.svg(check.name), "Depth along the canal against steady varied flow with the friction of its hydraulic radius; velocity across it; level in time."))
    check.best, check.cost = options_text(flow), flow.cost_text
    account(check, flow)
    return check


def uniform(study):
    return _canal(study, Check("open_canal", "Uniform flow in a canal with open ends",
                               "A trapezoidal canal twenty depths long, fed with its uniform discharge and the velocities of uniform flow over its section."))


def backed_up(study):
    return _canal(study, Check("open_canal_m1", "Backwater in a canal with open ends",
                               "The same canal with a fifth more depth held at its outflow, from the curve of riffle backwater: what enters must stand as high as that says."),
                  'outflow.kind="depth"', 'outflow.depth="180 mm"', 'start.kind="backwater"')


CHECKS = {"open_canal": uniform, "open_canal_m1": backed_up}
