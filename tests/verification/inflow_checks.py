"""Water that enters otherwise than with a profile over the depth: that of a flow between side walls, and of another run with its eddies."""

import csv
import io
import subprocess

import numpy

import figures
from check import Check
from open_end_checks import account
from options import options_text
from runs import ROOT

# The channel is fed with the water of the periodic reach from 20 s on; what stands at a place at t entered about 0.5 s before.
RECORDED_FROM, UNTIL, WINDOW, DELAY = 20.0, 34.0, (2.0, 6.0), 0.5


class Boxes:
    """The water between two places along a channel in boxes of about three spacings, whose mean velocities are those of the eddies larger than
    that (a particle's own noise counts for a 27th): by height U, rms and -u'w' of them over time and plan, m/s."""

    def __init__(self, flow, begin, end, window):
        width, size = flow.parameters["channel"]["width"], 3 * flow.spacing
        nx, ny, nz = (max(1, round(extent / size)) for extent in (end - begin, width, flow.depth))
        moments = []
        for s in flow.snapshots():
            if not window[0] <= s.time <= window[1]:
                continue
            here = (s.x >= begin) & (s.x < end) & (s.z < flow.depth)
            box = [(part * count).astype(int).clip(0, count - 1) for part, count in
                   (((s.x[here] - begin) / (end - begin), nx), (s.y[here] / width, ny), (s.z[here] / flow.depth, nz))]
            key = (box[2] * ny + box[1]) * nx + box[0]
            count = numpy.bincount(key, minlength=nx * ny * nz)
            means = numpy.array([numpy.bincount(key, values[here], nx * ny * nz) / numpy.maximum(count, 1) for values in (s.u, s.v, s.w)])
            means[:, count < 5] = numpy.nan
            moments.append(means.reshape(3, nz, ny * nx))
        velocity = numpy.array(moments)
        mean = numpy.nanmean(velocity, axis=(0, 3))
        departure = velocity - mean[None, :, :, None]
        self.place = (numpy.arange(nz) + 0.5) / nz
        self.u = mean[0]
        self.rms = dict(zip("uvw", numpy.sqrt(numpy.nanmean(departure**2, axis=(0, 3)))))
        self.stress = -numpy.nanmean(departure[:, 0] * departure[:, 2], axis=(0, 2))


def turbulence(study):
    case = "cases/open-ends/resolved-eddies.toml"
    check = Check("open_turbulence", "Turbulence that enters",
                  "Condition 2 with resolved eddies: a channel nine depths long that the water of a periodic reach enters keeps its mean flow and its eddies.")
    reach = study.run("open_turbulence_reach", "cases/rough-bed-3d/resolved-eddies.toml",
                      {"numerics.spacing": '"3 mm"', "run.until": f'"{UNTIL:g} s"', "output.snapshot_interval": '"0.2 s"', "numerics.density_relaxation": "0"})  # as in the channel
    series = reach.series
    late = series["time"] > RECORDED_FROM
    q = float((series["total_mean_velocity"] * series["mean_level"])[late].mean())
    results = reach.folder / "results.h5"
    flow = study.run("open_turbulence", case, {
        "inflow.unit_discharge": f'"{q:.5f} m2/s"', "inflow.profile": "results", "inflow.results": f'"{results}"',
        "start.kind": "results", "start.file": f'"{results}"'})
    recorded = Boxes(reach, 0.0, reach.length, tuple(RECORDED_FROM + time - DELAY for time in WINDOW))
    middle = (recorded.place > 0.2) & (recorded.place < 0.8)
    figure = figures.Figure(3, width=10)
    panels = [figure.panel("U (m/s)", "z/H", ""), figure.panel("u', w' of eddies (m/s)", "z/H", ""), figure.panel("$-\\overline{u'w'}$ (cm2/s2)", "z/H", "")]
    curves = lambda rows: ((rows.u,), (rows.rms["u"], rows.rms["w"]), (1e4 * rows.stress,))
    for axes, values in zip(panels, curves(recorded)):
        for number, curve in enumerate(values):
            figures.exact(axes, curve, recorded.place, "periodic reach" if number == 0 else None)
    for number, share in enumerate((0.25, 0.5, 0.75)):
        half = 0.125 * flow.length
        rows = Boxes(flow, share * flow.length - half, share * flow.length + half, WINDOW)
        name = f"at {share:.0%} of the length"
        check.norm(f"U(z) over its mean {name} against that of the reach, rms",
                   float(numpy.sqrt(((rows.u / rows.u.mean() - recorded.u / recorded.u.mean()) ** 2).mean())), 0.05)
        for axis in "uvw":
            check.norm(f"{axis}' of eddies larger than three spacings, 0.2 to 0.8 of the depth, {name}, over that of the reach, less one",
                       float(rows.rms[axis][middle].mean() / recorded.rms[axis][middle].mean() - 1), 0.1)
        check.norm(f"-<u'w'> of them {name}, over that of the reach, less one",
                   float(rows.stress[middle].mean() / recorded.stress[middle].mean() - 1), 0.15)
        for axes, values in zip(panels, curves(rows)):
            for curve in values:
                figures.simulated(axes, curve, rows.place, name if curve is values[0] else None, figures.COLOURS[number])
    levels = flow.series["mean_level"][flow.series["time"] > WINDOW[0]]
    check.norm("mean level, largest departure from its mean", float(numpy.abs(levels / levels.mean() - 1).max()), 0.01)
    check.figures.append((figure.svg(check.name), "Mean velocity, intensities and Reynolds stress of eddies larger than three spacings at three places against those of the reach whose water enters."))
    check.best, check.cost = options_text(flow), flow.cost_text
    account(check, flow)
    return check


def section_means(study, case, *settings):
    """The section twin of a case with settings, as the command line has them: y and the mean velocity over the depth there."""
    options = [word for setting in settings for word in ("--set", setting)]
    text = subprocess.run([str(study.riffle), "section", case, "--csv", "-", *options], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    cells = numpy.array([[float(value) for value in row] for row in csv.reader(io.StringIO(text)) if row[0][0].isdigit()])
    y, z = (numpy.unique(cells[:, axis]) for axis in (0, 1))
    faces = numpy.zeros(z.size + 1)
    for k, middle in enumerate(z):
        faces[k + 1] = 2 * middle - faces[k]
    return y, numpy.diff(faces) @ cells[:, 2].reshape(z.size, y.size) / faces[-1]


def files_across(flow, place, half, start, width):
    """Depth means of the velocity in files of one spacing over a width, within `half` of a place, from the snapshots from a time on, not a
    number where no water is, and of how many particles they are: y, U, count."""
    files = round(width / flow.spacing)
    count, sums = numpy.zeros(files), numpy.zeros(files)
    for s in flow.snapshots():
        if s.time >= start:
            near = numpy.abs(s.x - place) < half
            file = (s.y[near] / width * files).astype(int).clip(0, files - 1)
            count += numpy.bincount(file, minlength=files)
            sums += numpy.bincount(file, s.u[near], files)
    return (numpy.arange(files) + 0.5) * width / files, numpy.where(count > 0, sums / numpy.maximum(count, 1), numpy.nan), count


def means_across(flow, place, half, start):
    """The same over half of the channel: y, U."""
    return files_across(flow, place, half, start, 0.5 * flow.parameters["channel"]["width"])[:2]


def side_walls(study):
    check = Check("open_side_walls", "Uniform flow between side walls and open ends",
                  "Half of a flume between glass walls, ten depths long: water that enters with the profile of the section twin keeps it.")
    return _between_walls(study, check, "cases/open-ends/side-walls.toml", "cases/plane-beds/flume.toml", 0.1)


def strip(study):
    check = Check("open_strip", "A strip of gravel between open ends",
                  "Half of a flume between glass walls with a strip of gravel along its middle: water that enters with the profile of the section twin keeps it.")
    return _between_walls(study, check, "cases/open-ends/strip.toml", "cases/plane-beds/flume-strip.toml", 0.05,
                          "channel.depth=72mm", "numerics.spacing=6mm")


def _between_walls(study, check, case, periodic, half, *settings):
    """U(y) within `half` of three places along a channel with open ends against the section twin of the case of the same channel with periodic ones."""
    flow = study.run(check.name, case)
    start = flow.parameters["run"]["average_from"]
    twin_y, twin_u = section_means(study, periodic, *settings)
    figure = figures.Figure(2)
    axes = figure.panel("distance from the wall y (m)", "depth mean of u (m/s)", f"means from {start:g} s on")
    figures.exact(axes, twin_y, twin_u, "section twin")
    for number, share in enumerate((0.25, 0.5, 0.75)):
        y, u = means_across(flow, share * flow.length, half, start)
        twin = numpy.interp(y, twin_y, twin_u)
        check.norm(f"U(y) at {share:.0%} of the length, rms over the twin's mean", float(numpy.sqrt(((u - twin) ** 2).mean()) / twin.mean()), 0.03)
        check.norm(f"U(y) in the file beside the wall at {share:.0%} of the length, over the twin's, less one", float(u[0] / twin[0] - 1))
        figures.simulated(axes, y, u, f"at {share:.0%} of the length", figures.COLOURS[number])
    time, level = flow.series["time"], flow.series["mean_level"]
    check.norm("mean level, largest departure from H from 1 s on", float(numpy.abs(level[time > 1] / flow.depth - 1).max()), 0.01)
    # Slip: what the walls push along the channel is nobody's; the friction of bed and sides is booked as drag.
    check.norm("force of the walls along the channel over the weight of the water, mean",
               float(flow.values["wall_over_gravity"]), 0.02)
    axes = figure.panel("time t (s)", "mean level over H", "")
    figures.exact(axes, [0, time[-1]], [1, 1], "depth of the case")
    figures.simulated(axes, time, level / flow.depth, "particles", most=400)
    check.figures.append((figure.svg(check.name), "Depth-mean velocity across half of the flume at three places, and the level in time."))
    check.best, check.cost = options_text(flow), flow.cost_text
    account(check, flow)
    return check


CHECKS = {"open_turbulence": turbulence, "open_side_walls": side_walls, "open_strip": strip}
