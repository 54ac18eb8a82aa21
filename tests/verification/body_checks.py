"""Solids that turn and float: forces and moments of still and sheared water, draughts, periods of heave and roll, bodies that sink."""

import math

import h5py
import numpy

import exact
import figures
import floating
from check import Check
from options import options_text

GRAVITY = 9.81


def _late(flow, name, begin):
    return float(flow.forces[name][flow.forces["time"] > begin].mean())


def _water_volume(flow):
    """The volume of the water by the density of its particles, which its own weight presses together."""
    with h5py.File(flow.folder / "results.h5", "r") as file:
        return float(file["/time_series/water_volume"][:].mean())


def plate(study):
    check = Check("inclined_plate", "A plate held under still water",
                  "Force and moment of still water on a plate at an angle, against Archimedes. Bar: what a surface out of its place by a twentieth of the spacing makes of the volume.")
    for name, settings in [("", {}), (", 3 mm", {"numerics.spacing": '"3 mm"'})]:
        if study.quick and name:
            continue
        flow = study.run("inclined_plate" + "".join(c for c in name if c.isalnum()), "cases/bodies/inclined-plate.toml", settings)
        buoyancy = 1000 * GRAVITY * 0.12 * 0.024
        check.norm(f"force upward over the buoyancy, less one{name}", _late(flow, "solid_lift_1", 1.5) / buoyancy - 1, 0.02)
        check.norm(f"moment over that of the buoyancy, less one{name}", _late(flow, "solid_moment_y_1", 1.5) / (0.04 * buoyancy) - 1, 0.02)
        check.best, check.cost = options_text(flow), flow.cost_text
    return check


def couette(study):
    check = Check("cylindrical_couette", "A cylinder turns in another one",
                  "Torque on both cylinders against 4 pi mu Omega R1^2 R2^2/(R2^2 - R1^2), and the velocity between them. The bar is that of the cavity's walls.")
    torque = 4 * math.pi * 1e-2 * 0.02**2 * 0.04**2 / (0.04**2 - 0.02**2)
    for name, settings in [("", {}), (", 1.5 mm", {"numerics.spacing": '"1.5 mm"'})]:
        flow = study.run("cylindrical_couette" + "".join(c for c in name if c.isalnum()), "cases/bodies/couette.toml", settings)
        check.norm(f"torque on the inner cylinder, less one{name}", -_late(flow, "solid_moment_y_1", 30) / torque - 1, 0.02)
        outer = _late(flow, "solid_moment_y_2", 30) + _late(flow, "solid_moment_y_3", 30)
        check.norm(f"torque on the outer cylinder, less one{name}", outer / torque - 1, 0.02)
        check.best, check.cost = options_text(flow), flow.cost_text
    return check


def draught(study):
    check = Check("floating_draught", "A floating box comes to rest",
                  "Draught of a box of half the density of water by Archimedes: its bottom below the level, which is that of the water and the box. Bars: 1 % in the plane, 2 % of the height in space.")
    density = 500.0
    runs = [("", "floating-box", {}, 0.01), (", 5 mm", "floating-box", {"numerics.spacing": '"5 mm"'}, 0.02), (", in space", "floating-box-3d", {}, 0.02),
            (", in space, faces 0.2 spacings outside the lattice's", "floating-box-3d", {"solid.box.size": '["82 mm", "82 mm", "52 mm"]'}, None)]
    for name, case, settings, bar in runs:
        if study.quick and name:
            continue
        flow = study.run("floating_draught" + "".join(c for c in name if c.isalnum()), f"cases/bodies/{case}.toml", settings)
        solid, space = flow.parameters["solid"][0], case.endswith("3d")
        height = solid["size"][-1]
        base = flow.length * (flow.parameters["channel"]["width"] if space else 1.0)
        area = solid["size"][0] * (solid["size"][1] if space else 1.0)
        # The water's volume and what the box has of it in the end make the level.
        level = (_water_volume(flow) + area * height * density / flow.density) / base
        bottom = _late(flow, "body_z_1", flow.forces["time"][-1] - 1.0) - height / 2
        of = height * density / flow.density
        check.norm(f"draught less that of Archimedes, over the height{name}" if space else f"draught over that of Archimedes, less one{name}",
                   (level - bottom - of) / (height if space else of), bar)
        check.best, check.cost = options_text(flow), flow.cost_text
    return check


def _swing(time, value):
    """Period and logarithmic decrement over the crossings and extremes of a decaying oscillation around zero."""
    sign = numpy.nonzero(numpy.diff(numpy.signbit(value)))[0]
    crossings = [time[i] - value[i] * (time[i + 1] - time[i]) / (value[i + 1] - value[i]) for i in sign]
    period = crossings[2] - crossings[0]
    first, second = (numpy.abs(value[(time > a) & (time < b)]).max() for a, b in zip(crossings[:2], crossings[1:3]))
    return period, math.log(first / second) / math.pi


def swing(study, name, case, coefficients, mass, stiffness, value_of):
    check = Check(name, f"A floating box swings in {name.split('_')[1]}",
                  "The first whole swing against linear theory: added mass and wave damping at its frequency by a boundary element method (tests/verification/floating.py). The bar of the period allows for waves of the first moments.")
    flow = study.run(name, case, {})
    value = value_of(flow)
    period, damping = _swing(flow.forces["time"], value)
    expected, share = floating.natural_period(mass, stiffness, coefficients)
    check.norm("period over that of linear theory with its damping, less one", period / (expected / math.sqrt(1 - share**2)) - 1, 0.03)
    check.norm("share of critical damping, less that of linear theory", damping - share, None)
    figure = figures.Figure(1, width=7)
    motion = name.split("_")[1]
    panel = figure.panel("time (s)", f"{motion} ({'m' if motion == 'heave' else 'rad'})")
    figures.simulated(panel, flow.forces["time"][::4], value[::4], "particles", figures.COLOURS[0])
    frequency = 2 * math.pi / expected
    t = flow.forces["time"]
    figures.exact(panel, t, value[0] * numpy.exp(-share * frequency * t) * numpy.cos(frequency * math.sqrt(1 - share**2) * t), "linear theory at its natural frequency")
    check.figures.append((figure.svg(check.name), "The swing of the box, and that of one mass and damping. The first waves come back from the ends of the tank after some 1.4 s."))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


def heave(study):
    return swing(study, "floating_heave", "cases/bodies/heaving-box.toml", lambda w: floating.radiation(0.2, 0.1, 0.45, w, "heave"), 500 * 0.2 * 0.2, 1000 * GRAVITY * 0.2,
                 lambda flow: flow.forces["body_z_1"] - (_water_volume(flow) + 0.5 * 0.2**2) / flow.length)


def roll(study):
    stiffness = 1000 * GRAVITY * 0.3 * 0.05 * (0.3**2 / 12 / 0.05 + 0.025 - 0.05)
    return swing(study, "floating_roll", "cases/bodies/rolling-box.toml", lambda w: floating.radiation(0.3, 0.05, 0.45, w, "roll", 0.0), 0.2622, stiffness,
                 lambda flow: flow.forces["body_angle_y_1"] - math.radians(10))


def underturn(study):
    check = Check("floating_underturn", "A floe before an ice cover",
                  "A floating block is let go in a stream before an ice cover, between open ends: it is held there, or turned under by the stream where that is faster than the "
                  "velocity of Ashton (1974). The velocity is that between the fastest stream in which it stays afloat and the slowest one that turns it under.")
    thickness, density = 0.04, 0.5
    figure = figures.Figure(1, width=7)
    axes = figure.panel("time (s)", "pitch (degrees)", "velocity of the stream over Ashton's")
    afloat, under = [0.0], []
    for n, share in enumerate((0.9, 1.1) if study.quick else (0.8, 0.9, 1.0, 1.1, 1.2)):
        gap = 1 - thickness / 0.16
        critical = 2 * gap / math.sqrt(5 - 3 * gap**2) * math.sqrt(GRAVITY * thickness * (1 - density))
        flow = study.run(f"floating_underturn_{share:g}", "cases/bodies/floe.toml", {"inflow.unit_discharge": f'"{share * critical * 0.16:.5g} m2/s"'})
        time, pitch = flow.forces["time"], numpy.degrees(flow.forces["body_angle_y_2"])
        (under if numpy.abs(pitch).max() > 90 else afloat).append(share)
        figures.exact(axes, time, pitch, f"{share:g}", figures.COLOURS[n % len(figures.COLOURS)])
    check.norm("velocity that turns it under over that of Ashton, less one", 0.5 * (max(afloat) + min(under)) - 1 if under and max(afloat) < min(under) else math.nan, 0.1)
    check.norm("fastest stream in which it stays afloat, over that", max(afloat), unit="")
    check.figures.append((figure.svg(check.name), "Pitch of the floe, which is let go after 3 s."))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


def sinking(study):
    check = Check("sinking_cylinder", "A cylinder sinks between two walls",
                  "Terminal velocity at Re = 0.07 against the drag of Faxen (1946) for a cylinder of a quarter of the width. Bar: 5 %, a twentieth of a spacing on a radius of five, and its weight.")
    k = 0.25
    factor = -4 * math.pi / (0.9157 + math.log(k) - 1.724 * k**2 + 1.730 * k**4 - 2.406 * k**6 + 4.591 * k**8)
    expected = 200 * GRAVITY * math.pi * 0.005**2 / factor
    flow = study.run("sinking_cylinder", "cases/bodies/sinking-cylinder.toml", {})
    check.norm("velocity over that of Faxen, less one", -_late(flow, "body_velocity_z_1", 1.5) / expected - 1, 0.05)
    time = flow.forces["time"]
    for moment in (0.1, 0.25, 0.5, 1.0):  # sound swings it in 0.1 s
        around = numpy.abs(time - moment) <= 0.05 + 1e-9
        check.norm(f"the same around {moment:g} s after the start", float(-flow.forces["body_velocity_z_1"][around].mean() / expected - 1))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


def sinking_sphere(study):
    check = Check("sinking_sphere", "A sphere sinks in a box of oil",
                  "Largest velocity at Re = 31.9 against that of the experiment of ten Cate et al. (2002), 0.955 of Abraham's 0.128 m/s; begins as a sphere without friction and its added mass. Bar: 5 %, as for the drag of a sphere in a stream.")
    measured = 0.955 * 0.128
    figure = figures.Figure(1, width=7)
    panel = figure.panel("time (s)", "velocity downward (m/s)")
    for number, (name, settings) in enumerate([("", {}), (", 9 spacings across", {"numerics.spacing": '"1.6667 mm"', "run.until": '"1 s"'})]):
        flow = study.run("sinking_sphere" + "".join(c for c in name if c.isalnum()), "cases/bodies/sinking-sphere.toml", settings)
        time, velocity = flow.forces["time"], -flow.forces["body_velocity_z_1"]
        # Sound swings it: means over 50 ms.
        width = max(1, round(0.05 / (time[1] - time[0])))
        mean = numpy.convolve(velocity, numpy.ones(width) / width, "valid")
        check.norm(f"largest velocity over the measured one, less one{name}", float(mean.max()) / measured - 1, 0.05 if name else None)
        density = flow.parameters["solid"][0]["density"]
        begin = GRAVITY * (density - flow.density) / (density + 0.5 * flow.density)
        check.norm(f"velocity after 10 ms over that of its weight and added mass, less one{name}", float(numpy.interp(0.01, time, velocity)) / (0.01 * begin) - 1)
        figures.simulated(panel, time, velocity, f"{0.015 / flow.spacing:.3g} spacings across", figures.COLOURS[number], most=300)
        if not name:
            figures.exact(panel, [0, time[-1]], [measured] * 2, "largest in the experiment")
            check.best, check.cost = options_text(flow), flow.cost_text
    check.figures.append((figure.svg(check.name), "Velocity of the sphere, and the largest that was measured."))
    return check


def _height(time, surface, frequency, begin, end):
    """Height, crest to trough, of the waves of a frequency over whole periods, by place."""
    inside = (time > begin) & (time <= end)
    return 4 * numpy.abs(numpy.mean((surface[inside] - surface[inside].mean(axis=0)) * numpy.exp(2j * math.pi * frequency * time[inside])[:, None], axis=0))


def wavemaker(study):
    check = Check("wavemaker_in_space", "A paddle over half of the width of a tank",
                  "Waves along the tank (mode 0) and waves that run to and fro across it (mode 1, cos(pi y/W)), from rest on, against linear theory in the closed tank. "
                  "The bar is that of the wavemaker in the plane.")
    flow = study.run("wavemaker_in_space", "cases/bodies/wavemaker-3d.toml")
    paddle, width = flow.parameters["solid"][0], flow.parameters["channel"]["width"]
    frequency, face = paddle["frequency"], paddle["centre"][0] + 0.5 * paddle["size"][0]
    with h5py.File(flow.folder / "results.h5", "r") as file:
        time, x, y, elevation = (file["/surface_map"][key][:] for key in ("time", "x", "y", "elevation"))
    end = time[-1]
    begin = end - 2 / frequency
    share = paddle["size"][1] / width
    figure = figures.Figure(2, width=10)
    history = figure.panel("time (s)", "surface (mm)", "5 depths from the paddle")
    heights = figure.panel("distance from the paddle (m)", "height of the waves (mm)", f"{begin:.1f} to {end:.1f} s")
    inside = (x > face + 0.33) & (x < face + 0.6)
    place = int(numpy.argmin(numpy.abs(x - face - 0.5)))
    for n in range(2):
        mode = numpy.cos(n * math.pi * y / width)
        amplitude = paddle["amplitude_x"] * (share if n == 0 else 2 * math.sin(n * math.pi * share) / (n * math.pi))
        found = numpy.tensordot(elevation - numpy.nanmean(elevation[0]), mode, axes=(1, 0)) / (mode**2).sum()
        theory = exact.paddle_waves(time, x - face, amplitude, 2 * math.pi * frequency, n * math.pi / width, flow.depth, flow.length - face, GRAVITY)
        measured, expected = (_height(time, surface, frequency, begin, end) for surface in (found, theory))
        check.norm(f"mode {n}: height of the waves over linear theory, less one, 3.3 to 6 depths from the paddle, last two periods",
                   float(measured[inside].mean() / expected[inside].mean()) - 1, 0.05)
        check.norm(f"mode {n}: rms departure of the surface there from linear theory over the rms of the latter, whole run",
                   float(numpy.sqrt(numpy.mean((found - theory)[:, inside] ** 2) / numpy.mean(theory[:, inside] ** 2))))
        figures.exact(history, time, 1e3 * theory[:, place], "linear theory" if n == 0 else None)
        figures.simulated(history, time, 1e3 * found[:, place], f"mode {n}", figures.COLOURS[n])
        beyond = x > face
        figures.exact(heights, x[beyond] - face, 1e3 * expected[beyond], None)
        figures.simulated(heights, x[beyond] - face, 1e3 * measured[beyond], f"mode {n}", figures.COLOURS[n])
    check.figures.append((figure.svg(check.name), "The surface by its modes across the tank."))
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


CHECKS = {"wavemaker_in_space": wavemaker, "inclined_plate": plate, "cylindrical_couette": couette, "floating_draught": draught, "floating_heave": heave, "floating_roll": roll, "floating_underturn": underturn, "sinking_cylinder": sinking, "sinking_sphere": sinking_sphere}
