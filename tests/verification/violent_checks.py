"""Violent flow: water that breaks, falls and hits, with the preset for it."""

import csv
import math

import h5py
import numpy

import exact
import figures
from check import Check
from options import options_text
from runs import ROOT
from table import Table

# The largest sample over the largest mean of 3 ms.
SCATTER = 1.3
MEAN = 3e-3

# What arrives first hits a gauge for so long, s.
ARRIVAL = 0.08


def _gauges(flow, name):
    """Time and pressure (samples, points) of a gauge."""
    with h5py.File(flow.folder / "results.h5", "r") as file:
        group = file["/probes"][name]
        return group["time"][:], group["pressure"][:].astype(float)


def _smooth(time, values):
    """Running mean over 3 ms."""
    width = max(3, round(MEAN * (len(time) - 1) / (time[-1] - time[0])) | 1)
    return numpy.convolve(values, numpy.ones(width) / width, "same")


def _scatter(time, pressure, start, end):
    """The largest sample over the largest 3 ms mean, of the worst gauge, in a span of time."""
    inside = (time > start) & (time < end)
    return max(pressure[inside, k].max() / _smooth(time, pressure[:, k])[inside].max() for k in range(pressure.shape[1]))


def _arrival(flow, name):
    """The worst of the gauges while the water arrives at it (none, where all are wet from the start), and from then on.

    A gauge that stays dry says nothing."""
    with h5py.File(flow.folder / "results.h5", "r") as file:
        wet = file["/probes"][name]["wet_share"][:] > 0.05
    time, pressure = _gauges(flow, name)
    early, late = [], []
    for k in numpy.flatnonzero(wet.any(0)):
        first = time[wet[:, k].argmax()]
        rest = -1.0
        if not wet[0, k]:
            rest = first + ARRIVAL
            early.append(_scatter(time, pressure[:, k:k + 1], first - MEAN, rest))
        late.append(_scatter(time, pressure[:, k:k + 1], rest, time[-1]))
    return max(early, default=None), max(late)


def _energy(flow, snapshot):
    """Kinetic and potential energy per mass of a snapshot; of lost particles too they are gone."""
    return 0.5 * numpy.mean(snapshot.u**2 + snapshot.v**2 + snapshot.w**2) + flow.gravity_z * numpy.mean(snapshot.z)


def _history(flow):
    """Time and energy over that of the start."""
    rows = numpy.array([(s.time, _energy(flow, s)) for s in flow.snapshots()])
    return rows[:, 0], rows[:, 1] / rows[0, 1]


def _lost(flow):
    """Particles that left, and of these those that went through a wall or the bed."""
    with h5py.File(flow.folder / "results.h5", "r") as file:
        ways = file["/lost_particles/exit"][:]
    return len(ways), int((ways >= 4).sum())


def _survival(check, flow, name):
    """What must hold of every violent run that has come to its end."""
    count, through = _lost(flow)
    check.norm(f"{name}: share of the water that left the tank", flow.values["lost_share"], 1e-3, "%")
    check.norm(f"{name}: particles through a wall or the bed", through, 0, "", 3)
    return count


def _pictures(flow, times, title, limit):
    """The water at some times, its pressure in colour."""
    figure = figures.Figure(len(times), 4.2 * len(times), 2.6)
    for time in times:
        s = flow.snapshot(int(numpy.argmin(numpy.abs(flow.snapshot_time - time))))
        axes = figure.panel("place x (m)", "height z (m)", f"t = {s.time:.2f} s")
        drawn = axes.scatter(s.x, s.z, c=s.pressure / 1000, s=1.5, cmap="coolwarm", vmin=-limit, vmax=limit, linewidths=0, rasterized=True)
        axes.set_aspect("equal")
    figure.figure.colorbar(drawn, ax=figure.panels, label="pressure (kPa)", shrink=0.8)
    return figure.svg(title)


# What each part of the preset does: the dam break at 10 mm with the preset, without its parts, and with the default numerics.
PARTS = {"as the case": {}, "no damping of sound": {"numerics.acoustic_damping": "0"}, "no dissipation of impacts": {"numerics.impact_dissipation": "0"},
         "semi-implicit Euler": {"numerics.stepping": '"semi-implicit-euler"'}, "the default numerics": {"numerics.preset": '"riffle"'}}


def _parts(study):
    """Scatter and energy of the dam break against a wall, for PARTS."""
    rows = []
    for number, (name, settings) in enumerate(PARTS.items()):
        flow = study.try_run(f"impact-part-{number}", "cases/violent/dam-break.toml", {"numerics.spacing": '"10 mm"', **settings})
        if flow is None:
            rows.append([name, "fails", "", "", ""])
            continue
        time, pressure = _gauges(flow, "wall_pressure")
        run_up = (time > 0.5) & (time < 1.0)
        departure = (pressure[:, 0] - _smooth(time, pressure[:, 0]))[run_up]
        clock, e = _history(flow)
        rows.append([name, f"{_scatter(time, pressure, 0.5, 1.0):.2f}", f"{math.sqrt(numpy.mean(departure**2)):.0f}", f"{numpy.interp(1.0, clock, e):.3f}", f"{e[-1]:.3f}"])
    return study.table("Dam break against a wall, 10 mm: parts of the preset",
                       ["numerics", "samples / 3 ms means, 0.5 to 1 s", "rms of the departure 3 mm above the bed, Pa", "energy at 1 s", "at 3 s"], rows)


def impact(study):
    check = Check("impact", "Dam break against a wall",
                  "A reservoir twice as long as deep, in a tank 5.37 depths long (Buchner 2002; Lobovsky et al. 2014). Measured: the pressure of Buchner's "
                  "disc, from 0.133 to 0.267 depths above the bed, which stands at 0.545 ρgH from t√(g/H) = 3.2 to 5.2. There is no air in the simulation, so the peak when "
                  "the cavity under the falling water closes (t√(g/H) about 8) is that of water on water. While the thin front arrives (the first 0.09 s), particles hit the gauges one by one.")
    spacings = ["10 mm"] if study.quick else ["10 mm", "5 mm", "3 mm"]
    table = Table("Dam break against a wall: spacings", ["spacing", "front at the wall, t√(g/H)", "disc / ρgH", "at 3 mm / ρgH", "samples / 3 ms means, first 0.09 s", "to 1 s", "after",
                                                        "energy at 1 s", "at 3 s", "lost", "s of a core"])
    figure = figures.Figure(3, 13, 3.2)
    early = figure.panel("time t√(g/H)", "pressure of the disc / ρgH", "mean of 3 ms")
    all_of_it = figure.panel("time t√(g/H)", "pressure 3 mm above the bed / ρgH", "mean of 3 ms")
    energy = figure.panel("time t (s)", "kinetic + potential energy / at the start")
    figures.exact(early, exact.BUCHNER_PRESSURE[:, 0], exact.BUCHNER_PRESSURE[:, 1], "Buchner, measured", marker="s", markersize=3, linestyle=":")
    finest = {}
    for spacing, colour in zip(spacings, figures.COLOURS):
        name = f"impact-{spacing.replace(' ', '')}"
        flow = study.run(name, "cases/violent/dam-break.toml", {"numerics.spacing": f'"{spacing}"', "output.snapshot_interval": '"20 ms"'})
        time, pressure = _gauges(flow, "wall_pressure")
        unit, scale = math.sqrt(flow.depth / flow.gravity_z), flow.density * flow.gravity_z * flow.depth
        means = numpy.array([_smooth(time, pressure[:, k]) for k in range(pressure.shape[1])]).T / scale
        disc = means[:, 3:6].mean(1)
        t = time / unit
        arrival = t[numpy.argmax(means[:, 0] > 0.1)]
        steady = (t > 3.2) & (t < 5.2)
        shock = _scatter(time, pressure[:, :3], arrival * unit - 0.01, arrival * unit + 0.08)
        run_up, rest = _scatter(time, pressure, arrival * unit + 0.08, 1.0), _scatter(time, pressure[:, :3], 1.0, 3.0)
        clock, e = _history(flow)
        count = _survival(check, flow, spacing)
        finest = {"disc": disc[steady].mean(), "shock": shock, "run_up": run_up, "rest": rest, "energy": numpy.interp(1.0, clock, e), "flow": flow, "arrival": arrival}
        check.norm(f"{spacing}: mean pressure of the disc, t√(g/H) from 3.2 to 5.2, against the measured", finest["disc"] / 0.545 - 1, 0.1)
        check.norm(f"{spacing}: largest sample over the largest 3 ms mean, 0.08 s after the front's arrival to 1 s", run_up, SCATTER, "", 3)
        check.norm(f"{spacing}: the same, from 1 s to the end, up to 30 mm", rest, SCATTER, "", 3)
        check.norm(f"{spacing}: the same, while the front arrives, up to 30 mm", shock, SCATTER, "", 3)
        table.rows.append([spacing, f"{arrival:.2f}", f"{finest['disc']:.3f}", f"{means[steady, 0].mean():.3f}", f"{shock:.2f}", f"{run_up:.2f}", f"{rest:.2f}",
                           f"{numpy.interp(1.0, clock, e):.3f}", f"{e[-1]:.3f}", f"{count}", f"{flow.cost:.0f}"])
        figures.simulated(early, t[t < 8], disc[t < 8], spacing, colour, 400)
        figures.simulated(all_of_it, t, means[:, 0], spacing, colour, 500)
        figures.simulated(energy, clock, e, spacing, colour)
    early.set_ylim(-0.2, 1.2)
    all_of_it.set_ylim(-0.2, 5)
    check.tables.append(table)
    if not study.quick:
        check.tables.append(_parts(study))
    check.norm("energy lost in the first second, before the wave has broken", 1 - finest["energy"], 0.05)
    check.best, check.cost = options_text(finest["flow"]), finest["flow"].cost_text
    check.figures.append((figure.svg(check.name), "Pressures at the wall and energy."))
    check.figures.append((_pictures(finest["flow"], [0.5, 0.9, 1.3], "impact-water", 3), "The water, its pressure in colour."))
    check.budgets_of(finest["flow"], energy=False)
    return check


def _violent(study, name, title, text, case, gauge, pictures, limit, spacings=("10 mm", "5 mm"), quick=("10 mm",)):
    """A run with each spacing: it must come to its end, lose no water, and scatter little."""
    check = Check(name, title, text)
    spacings = quick if study.quick else spacings
    table = Table(f"{title}: spacings", ["spacing", "largest 3 ms mean (kPa)", "samples / 3 ms means, first 0.08 s", "after", "energy in the end", "lost", "s of a core"])
    figure = figures.Figure(2)
    pressure_axes = figure.panel("time t (s)", "pressure of the first gauge (kPa)", "mean of 3 ms")
    energy_axes = figure.panel("time t (s)", "kinetic + potential energy / at the start")
    for spacing, colour in zip(spacings, figures.COLOURS):
        flow = study.run(f"{name}-{spacing.replace(' ', '')}", case, {"numerics.spacing": f'"{spacing}"'})
        time, pressure = _gauges(flow, gauge)
        mean = _smooth(time, pressure[:, 0])
        early, late = _arrival(flow, gauge)
        clock, e = _history(flow)
        count = _survival(check, flow, spacing)
        check.norm(f"{spacing}: largest sample over the largest 3 ms mean, from 0.08 s after the water's arrival at a gauge", late, SCATTER, "", 3)
        if early is not None:
            check.norm(f"{spacing}: the same, while the water arrives", early, SCATTER, "", 3)
        check.norm(f"{spacing}: gain of energy at any time", max(e.max() - 1, 0.0), 0.01)
        table.rows.append([spacing, f"{mean.max() / 1000:.2f}", "-" if early is None else f"{early:.2f}", f"{late:.2f}", f"{e[-1]:.3f}", f"{count}", f"{flow.cost:.0f}"])
        figures.simulated(pressure_axes, time, mean / 1000, spacing, colour, 500)
        figures.simulated(energy_axes, clock, e, spacing, colour)
    check.tables.append(table)
    check.best, check.cost = options_text(flow), flow.cost_text
    check.figures.append((figure.svg(name), "Pressure and energy."))
    check.figures.append((_pictures(flow, pictures, f"{name}-water", limit), "The water, its pressure in colour."))
    if count == 0:  # what leaves takes its momentum along
        check.budgets_of(flow, energy=False)
    return check


def box(study):
    return _violent(study, "box", "Dam break on a box", "The water hits a box on the bed, jumps over it and fills the tank behind.",
                    "cases/violent/box-2d.toml", "box_pressure", [0.4, 0.7, 1.2], 3, ("10 mm", "5 mm", "3 mm"))


def _measured_box():
    """Records of the experiment by name, every 0.1 s."""
    with open(ROOT / "cases/violent/box-3d-measured.csv") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {name: numpy.array([float(row[name]) for row in rows]) for name in rows[0]}


def _against_experiment(check, flow, name, panels, measured):
    """Levels and pressures of the dam break on a box beside the measured ones; `panels`: axes of the figure, or None."""
    depth = 0.55
    with h5py.File(flow.folder / "results.h5", "r") as file:
        time, elevation = file["/probes/level/time"][:], numpy.nan_to_num(file["/probes/level/elevation"][:].astype(float))
    squares = []
    for k in range(4):
        # Means over 20 ms: single drops pass.
        smooth = elevation[:, k].copy()
        smooth[1:-1] = numpy.convolve(elevation[:, k], numpy.ones(3) / 3, "valid")
        departure = numpy.interp(measured["time"][1:-1], time, smooth) - measured[f"level_{k + 1}"][1:-1]
        squares.append(departure**2)
        check.norm(f"{name}: rms of the level at x = {(0.582, 1.732, 2.228, 2.724)[k]} m over the first depth", math.sqrt(squares[-1].mean()) / depth)
        if panels:
            figures.exact(panels[k], measured["time"], measured[f"level_{k + 1}"], "measured", marker="s", markersize=3, linestyle=":")
            figures.simulated(panels[k], time, smooth, f"dx {name}")
    check.norm(f"{name}: rms of the four levels over the first depth, 0.1 to 2.9 s", math.sqrt(numpy.mean(squares)) / depth, 0.06)
    time, front = _gauges(flow, "box_pressure")
    arrival = time[(front[:, 0] > 500).argmax()]
    check.norm(f"{name}: arrival at the box against 0.393 s", arrival / 0.393 - 1, 0.05)
    top = _gauges(flow, "top_pressure")[1]
    for label, pressure, column, (begin, end), bar in (
            ("front, 21 mm", front[:, 0], "front_1", (0.5, 2.0), 0.15), ("front, 61 mm", front[:, 1], "front_2", (0.5, 2.0), 0.15),
            ("front, 101 mm", front[:, 2], "front_3", (0.5, 2.0), 0.15), ("front, 141 mm", front[:, 3], "front_4", (0.5, 2.0), 0.15),
            ("top, 21 mm", top[:, 0], "top_1", (1.5, 2.5), None),
            ("top, 141 mm", top[:, 1], "top_4", (1.5, 2.5), None)):
        theirs = measured[column][(measured["time"] > begin - 0.01) & (measured["time"] < end - 0.01)].mean()
        ours = pressure[(time >= begin) & (time < end)].mean()
        check.norm(f"{name}: mean pressure on the box, {label}, {begin:g} to {end:g} s, against {theirs:.0f} Pa", ours / theirs - 1, bar)
    return time, front


def box_3d(study):
    """In three dimensions: half of the tank, the box from an STL file."""
    check = Check("box_3d", "Dam break on a box in three dimensions",
                  "Kleefsman's tank (2005), half of it, with a box from an STL file in the water's way; levels and pressures against the experiment's.")
    flow = study.run("box_3d", "cases/violent/box-3d.toml")
    figure = figures.Figure(4, width=11)
    panels = [figure.panel("t (s)", "level (m)", f"x = {x} m") for x in (0.582, 1.732, 2.228, 2.724)]
    measured = _measured_box()
    time, front = _against_experiment(check, flow, "25 mm", panels, measured)
    check.figures.append((figure.svg("box_3d_levels"), "Levels in the tank."))
    pressures = figures.Figure(2, width=8)
    for k, height in ((0, 21), (2, 101)):
        axes = pressures.panel("t (s)", "p (kPa)", f"front of the box, {height} mm")
        figures.exact(axes, measured["time"] + 0.05, 1e-3 * measured[f"front_{k + 1}"], "measured, means over 0.1 s", marker="s", markersize=3, linestyle=":")
        width = round(0.1 / (time[1] - time[0]))
        middle = time[:time.size - width + 1] + 0.5 * width * (time[1] - time[0])
        figures.simulated(axes, middle, 1e-3 * numpy.convolve(front[:, k], numpy.ones(width) / width, "valid"), "dx 25 mm")
    check.figures.append((pressures.svg("box_3d_pressures"), "Pressure on the front of the box, means over 0.1 s."))
    if not study.quick:
        _against_experiment(check, study.run("box_3d_16", "cases/violent/box-3d.toml", {"numerics.spacing": '"16.7 mm"'}), "16.7 mm", None, measured)
    _survival(check, flow, "25 mm")
    early, late = _arrival(flow, "box_pressure")
    check.norm("25 mm: largest sample over the largest 3 ms mean, from 0.08 s after the water's arrival at a gauge", late, SCATTER, "", 3)
    check.norm("25 mm: the same, while the water arrives", early, SCATTER, "", 3)
    time, e = flow.series["time"], flow.series["kinetic_energy"] + flow.series["potential_energy"]
    check.norm("25 mm: gain of energy at any time", max((e / e[0]).max() - 1, 0.0), 0.01)
    for instant in (1, 2, 3):
        check.norm(f"25 mm: energy at {instant} s, kinetic and potential, over that at the start", numpy.interp(instant, time, e) / e[0], digits=3)
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


def lid(study):
    return _violent(study, "lid", "Sloshing against a lid", "The water runs up the far wall and against the lid of the tank.",
                    "cases/violent/lid.toml", "lid_pressure", [0.4, 0.6, 1.0], 3)


def falling_column(study):
    return _violent(study, "falling_column", "A column of water falls into a pool", "A column three times as high as the pool is deep plunges into it.",
                    "cases/violent/falling-column.toml", "bed_pressure", [0.2, 0.5, 1.0], 3)


def falling_block(study):
    return _violent(study, "falling_block", "A block of water drops on the floor", "The block hits the dry floor at 2 m/s: the pressure at its middle is that of water on a stiff wall.",
                    "cases/violent/falling-block.toml", "floor_pressure", [0.2, 0.3, 0.6], 3)


CHECKS = {"impact": impact, "box": box, "box_3d": box_3d, "lid": lid, "falling_column": falling_column, "falling_block": falling_block}
