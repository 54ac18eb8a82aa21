"""Channels that water enters and leaves: uniform and varied flow, waves that reach an end."""

import csv
import io
import json
import subprocess

import h5py
import numpy

import figures
from check import Check
from options import options_text
from runs import ROOT


def program(study, *arguments):
    """What a command of the program prints."""
    return subprocess.run([str(study.riffle), *arguments], cwd=ROOT, check=True, capture_output=True, text=True).stdout


def backwater(study, case, datum, *arguments):
    """Depth over the bed level of steady varied flow, as a function of x; `datum`: height of the zero datum, m."""
    stations = json.loads(program(study, "backwater", case, *arguments, "--json", "-"))["stations"]
    return lambda x: numpy.interp(x, stations["x"], stations["depth"]) + datum


def column_profile(study, *arguments):
    """Height and velocity of a column twin, by the arguments of `riffle column`."""
    table = program(study, "column", *arguments, "--csv")
    rows = list(csv.DictReader(line for line in io.StringIO(table) if not line.startswith("#")))
    return tuple(numpy.array([float(row[next(k for k in row if k.split(" ")[0] == name)]) for row in rows]) for name in ("z", "u"))


def surface_of(flow):
    """Times, places along the channel, and the level there, [time, place]."""
    with h5py.File(flow.folder / "results.h5", "r") as file:
        return tuple(file["/surface"][key][:] for key in ("time", "x", "elevation"))


def mean_surface(flow, start):
    """Places along the channel and the mean level there from a time on, m."""
    time, x, level = surface_of(flow)
    return x, numpy.nanmean(level[numpy.searchsorted(time, start):], axis=0)


def account(check, flow):
    """The account of the particles closes at each row of the time series."""
    s = flow.series
    balance = s["particles_stored"] - s["particles_entered"] + s["particles_left"] + s["particles_lost"]
    check.budget("particles", float(numpy.abs(balance - balance[0]).max()),
                 f"stored less entered plus left, largest change; {s['particles_entered'][-1]:.0f} entered, {s['particles_lost'][-1]:.0f} lost", 0.0)


def depth_by_area(flow, places, half, start):
    """Area of the water within `half` of a place, or of each of some places, over its length, mean over the snapshots from a time on, m:
    the depth of the water itself, without the gaps between drops."""
    counts = [[(numpy.abs(s.x - place) < half).sum() for place in numpy.atleast_1d(places)] for s in flow.snapshots() if s.time >= start]
    depths = numpy.mean(counts, axis=0) * flow.spacing**2 / (2 * half)
    return depths if numpy.ndim(places) else float(depths[0])


def _profile(flow, place, half, start):
    """Mean velocity in rows of one spacing about a place, from the snapshots from a time on: height, velocity."""
    rows = round(flow.depth / flow.spacing)
    sums = numpy.zeros((3, rows))
    for s in flow.snapshots():
        if s.time < start:
            continue
        near = numpy.abs(s.x - place) < half
        row = numpy.clip((s.z[near] / flow.depth * rows).astype(int), 0, rows - 1)
        for k, values in enumerate((numpy.ones(near.sum()), s.u[near], s.z[near])):
            sums[k] += numpy.bincount(row, values, rows)
    filled = sums[0] > 0
    return sums[2][filled] / sums[0][filled], sums[1][filled] / sums[0][filled]


def uniform(study):
    case = "cases/open-ends/uniform.toml"
    check = Check("open_uniform", "Uniform flow between open ends",
                  "Condition 2 in channels ten and a hundred depths long that are fed with the twin's profile: their flow is that of the channel without ends.")
    height, velocity = column_profile(study, "cases/rough-bed-2d/condition-2.toml")
    runs = [("", "open_uniform", {})] + ([] if study.quick else [(", a hundred depths long", "open_uniform_long", {"channel.length": '"5 m"', "numerics.spacing": '"2.5 mm"'})])
    for label, name, settings in runs:
        flow = study.run(name, case, settings)
        crest = flow.parameters["bed"]["roughness_height"]
        figure = figures.Figure(2)
        axes = figure.panel("velocity u (m/s)", "height z (m)", "at 25, 50 and 75 % of the length")
        figures.exact(axes, velocity, height, "column twin")
        for number, share in enumerate((0.25, 0.5, 0.75)):
            z, u = _profile(flow, share * flow.length, 0.03, 20.0)
            twin = numpy.interp(z, height, velocity)
            scale = twin.mean()
            for part_name, part, bar in (("above", z > crest, 0.01), ("below", z <= crest, 0.03)):
                check.norm(f"U(z) {part_name} the crests at {share:.0%} of the length, rms over the twin's mean{label}",
                           float(numpy.sqrt(numpy.mean((u - twin)[part] ** 2)) / scale), bar)
            figures.simulated(axes, u, z, f"{share:.0%}", figures.COLOURS[number])
        time = flow.series["time"]
        level = flow.series["mean_level"]
        axes = figure.panel("time t (s)", "mean level over H", "")
        figures.exact(axes, [0, time[-1]], [1, 1], "normal depth")
        figures.simulated(axes, time, level / flow.depth, "level", most=400)
        good = numpy.isfinite(level) & (time > 1)
        check.norm(f"mean level, largest departure from H in 60 s{label}", float(numpy.abs(level[good] / flow.depth - 1).max()), 0.005)
        late = time > 20
        check.norm(f"discharge that leaves, mean from 20 s on, against that which enters{label}",
                   float(flow.series["outflow_discharge"][late].mean() / flow.series["inflow_discharge"][late].mean() - 1), 0.01)
        x, mean = mean_surface(flow, 20.0)
        inside = (x > 0.1 * flow.length) & (x < 0.9 * flow.length)
        check.norm(f"slope of the surface from 10 to 90 % of the length against that of the bed{label}",
                   float(numpy.polyfit(x[inside], mean[inside], 1)[0]) / flow.parameters["channel"]["slope"], 0.05 if label else None)
        account(check, flow)
        check.figures.append((figure.svg(name), f"Velocity at three places against the column twin, and the level in time{label}."))
        if not label:
            check.best, check.cost = options_text(flow), flow.cost_text
    return check


def _smooth_law(height, friction_velocity, viscosity):
    """Velocity over a smooth bed (Nezu & Rodi 1986), no less than in the viscous layer."""
    plus = friction_velocity * height / viscosity
    return friction_velocity * numpy.maximum(numpy.log(numpy.maximum(plus, 1.0)) / 0.41 + 5.29, 0.0)


def smooth_bed(study):
    case = "cases/open-ends/smooth-channel.toml"
    check = Check("open_smooth", "Smooth channel",
                  "The channel of Tan, Cheng, Xie & Shao (2015), 1.2 m long at a spacing of 5 mm, with water 0.1, 0.2 and 0.4 m deep and Reynolds numbers up to 150 000: the velocity "
                  "over the whole depth against the smooth log law of Nezu & Rodi (1986).")
    figure = figures.Figure(1, width=7)
    axes = figure.panel("velocity over that of the law at the surface", "height over the depth", "middle of the length, mean from 15 s on")
    for number, (depth, slope, discharge) in enumerate([(0.2, 1.404e-4, 0.075), (0.1, 3.2355e-4, 0.0375), (0.4, 6.15e-5, 0.15)]):
        if study.quick and number:
            continue
        label = f"{depth:g} m deep"
        flow = study.run(f"open_smooth_{1e3 * depth:.0f}", case,
                         {"channel.depth": f'"{depth:g} m"', "channel.slope": f"{slope:g}", "inflow.unit_discharge": f'"{discharge:g} m2/s"'} if number else {})
        friction_velocity = float(numpy.sqrt(flow.gravity_z * flow.parameters["channel"]["slope"] * depth))
        law = lambda z: _smooth_law(z, friction_velocity, flow.parameters["fluid"]["kinematic_viscosity"])
        mean = float(law((numpy.arange(1000) + 0.5) / 1000 * depth).mean())
        for share in (0.25, 0.5, 0.75):
            z, u = _profile(flow, share * flow.length, 0.05, 15.0)
            check.norm(f"U(z) at {share:.0%} of the length, rms over the law's mean, {label}", float(numpy.sqrt(numpy.mean((u - law(z)) ** 2)) / mean), 0.03)
            if share == 0.5:
                apart = u / law(z) - 1
                worst = int(numpy.abs(apart).argmax())
                check.norm(f"largest departure of a row there, {label}", float(apart[worst]), 0.03)
                top = float(law(depth))
                heights = numpy.linspace(0.002, 1, 200) * depth
                figures.exact(axes, law(heights) / top, heights / depth, None if number else "smooth log law", figures.COLOURS[number])
                figures.simulated(axes, u / top, z / depth, label, figures.COLOURS[number])
        level = flow.series["mean_level"]
        check.norm(f"mean level, largest departure from the normal depth, {label}", float(numpy.nanmax(numpy.abs(level[flow.series["time"] > 1.0] / depth - 1))), 0.005)
        late = flow.series["time"] > 15.0
        check.norm(f"discharge that leaves against that which enters, {label}",
                   float(flow.series["outflow_discharge"][late].mean() / flow.series["inflow_discharge"][late].mean() - 1), 0.01)
        account(check, flow)
        if not number:
            check.best, check.cost = options_text(flow), flow.cost_text
    check.figures.append((figure.svg(check.name), "Velocity over a smooth bed against the log law."))
    return check


def _varied(study, name, title, text, downstream):
    case = f"cases/open-ends/{name.replace('_', '-')}.toml"
    check = Check("open_" + name, title, text)
    flow = study.run("open_" + name, case)
    bed = flow.parameters["bed"]
    exact = backwater(study, case, bed["roughness_height"] - bed["datum_below_crest"], "--discharge", "0.017411 m2/s", "--downstream", downstream, "--length", "1.2", "--stations", "601")
    x, level = mean_surface(flow, 10.0)
    inside = (x > 0.1 * flow.length) & (x < 0.9 * flow.length)
    check.norm("depth from 10 to 90 % of the length, largest departure of its mean from 10 s on from riffle backwater",
               float(numpy.abs(level / exact(x) - 1)[inside].max()), 0.01)
    check.norm("the same, rms", float(numpy.sqrt(numpy.mean((level / exact(x) - 1)[inside] ** 2))))
    figure = figures.Figure(1, width=7)
    axes = figure.panel("distance along the channel x (m)", "depth over the bed level (m)", "mean from 10 s on")
    figures.exact(axes, x, exact(x), "riffle backwater")
    figures.simulated(axes, x, level, "particles", most=200)
    check.figures.append((figure.svg(check.name), "Depth along the channel against steady varied flow."))
    check.best, check.cost = options_text(flow), flow.cost_text
    account(check, flow)
    return check


def m1(study):
    return _varied(study, "backwater_m1", "Backwater curve M1", "Held back at its end, 10 mm over the normal depth.", "60mm")


def m2(study):
    return _varied(study, "backwater_m2", "Backwater curve M2", "Drawn down at its end, 10 mm below the normal depth.", "40mm")


def pulse(study):
    check = Check("open_pulse", "A wave that leaves",
                  "A rise of the depth by 5 % runs down the uniform flow of condition 2 and out. What comes back is the difference from a channel three times as long, "
                  "in which nothing can have come back yet.")
    case = "cases/open-ends/pulse.toml"
    short = study.run("open_pulse", case)
    long = study.run("open_pulse_long", case, {"channel.length": '"3 m"'})

    def gauges(flow):
        with h5py.File(flow.folder / "results.h5", "r") as file:
            probe = file["/probes/gauges"]
            return probe["x"][:], probe["time"][:], probe["elevation"][:]
    x, time, level = gauges(short)
    _, _, undisturbed = gauges(long)
    # Long waves alone: the mean over a tenth of a second.
    smooth = lambda record: numpy.apply_along_axis(lambda r: numpy.convolve(r, numpy.ones(10) / 10, "same"), 0, record)
    rise = smooth(undisturbed - undisturbed[:30].mean(axis=0))
    back = smooth(level - undisturbed)
    height = rise.max(axis=0)
    inside = (time > 0.2) & (time < time[-1] - 0.2)
    check.norm("largest difference from the long channel at any gauge over the height of the pulse there",
               float((numpy.abs(back[inside]).max(axis=0) / height).max()), 0.05)
    check.norm("the same, rms after the pulse has passed",
               float((numpy.sqrt(numpy.mean(back[(time > 2.5) & inside] ** 2, axis=0)) / height).max()))
    figure = figures.Figure(1, width=7)
    axes = figure.panel("time t (s)", "rise of the level (mm)", "")
    for number, place in enumerate(x):
        figures.exact(axes, time, 1e3 * rise[:, number], f"x = {1e3 * place:.0f} mm", figures.COLOURS[number])
        figures.exact(axes, time, 1e3 * back[:, number], None, figures.COLOURS[number], linestyle=":")
    check.figures.append((figure.svg(check.name), "Level at the gauges in the long channel (lines), and what the short one differs from it by (dots)."))
    check.best, check.cost = options_text(short), short.cost_text
    account(check, short)
    return check


CHECKS = {"open_uniform": uniform, "open_smooth": smooth_bed, "open_backwater_m1": m1, "open_backwater_m2": m2, "open_pulse": pulse}
