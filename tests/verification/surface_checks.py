"""Water with a free surface: at rest, in waves, breaking dams, a drop, over a step."""

import math

import h5py
import numpy

import exact
import figures
from check import Check
from options import compare_options, options_text, refinement
from table import Table


def _largest_speeds(flow):
    """Time and largest speed of a particle of each snapshot."""
    return numpy.array([(s.time, numpy.hypot(s.u, s.w).max()) for s in flow.snapshots()])


def _speed_panel(figure, speeds, scale, bar, bar_from):
    axes = figure.panel("time t (s)", "largest speed / √(gH)", "")
    axes.set_yscale("log")
    figures.exact(axes, [bar_from, speeds[-1, 0]], [bar, bar], "bar")
    figures.simulated(axes, speeds[1:, 0], speeds[1:, 1] / scale, "particles")


def _stillness(study, check, case, still_level, solid_area, bar):
    """Largest speed, level and pressure of water that must stay at rest."""
    flow = study.run(check.name, case)
    scale = math.sqrt(flow.gravity_z * flow.depth)
    speeds = _largest_speeds(flow)
    last = flow.snapshot(-1)
    check.norm("largest speed of any particle in the end, over √(gH)", speeds[-1, 1] / scale, bar, "", 3)
    level = still_level(flow, (flow.mass * last.z).sum() / flow.mass.sum())
    volume_level = ((flow.mass / last.density).sum() + solid_area(flow)) / flow.length
    check.norm("level, told by the height of the centre of mass, against that of the water's volume, over H", (level - volume_level) / flow.depth, 0.005)
    pressure = flow.density * flow.gravity_z * (flow.depth - last.z)
    below = last.z < flow.depth - 2 * flow.smoothing_length
    check.norm("rms of p − ρg(H − z) more than 2h below the surface, over ρgH",
               math.sqrt(numpy.mean((last.pressure - pressure)[below] ** 2)) / (flow.density * flow.gravity_z * flow.depth), 0.01)
    check.best, check.cost = options_text(flow), flow.cost_text
    figure = figures.Figure(2)
    axes = figure.panel("pressure p / ρgH", "height z / H", f"t = {last.time:.3g} s")
    figures.exact(axes, [1, 0], [0, 1], "hydrostatic")
    figures.simulated(axes, last.pressure / (flow.density * flow.gravity_z * flow.depth), last.z / flow.depth, most=600)
    _speed_panel(figure, speeds, scale, bar, speeds[0, 0])
    check.figures.append((figure.svg(check.name), "Pressure of all particles in the end, and the largest speed against time."))
    check.budgets_of(flow, energy=False)
    e = 0.5 * (flow.mass * (last.u**2 + last.w**2)).sum()
    check.budget("energy", f"{e / (flow.mass.sum() * flow.gravity_z * flow.depth):.1e}", "kinetic energy in the end over M g H (exact: 0)")
    return flow


def tank(study):
    check = Check("tank", "Hydrostatic tank", "Still water in a closed tank must stay still and keep its level.")
    flow = _stillness(study, check, "cases/checks/hydrostatic-tank.toml", lambda f, centre: 2 * centre, lambda f: 0.0, 1e-4)
    if not study.quick:
        compare_options(study, check, "cases/checks/hydrostatic-tank.toml", {
            "square lattice, h = 1.5 dx": {"start.lattice": "square", "numerics.smoothing_ratio": "1.5"},
            "hexagonal, h = 2.15 dx": {"numerics.smoothing_ratio": "2.15", "numerics.wall_layers": "5"},
            "the default density diffusion": {"numerics.density_diffusion": "fourtakas"},
            "viscosity of water": {"fluid.kinematic_viscosity": "1e-6"}},
            flow, lambda f: max(numpy.hypot(s.u, s.w).max() for s in [f.snapshot(-1)]) / math.sqrt(f.gravity_z * f.depth), "largest speed / √(gH)")
    return check


def wedge(study):
    check = Check("wedge", "Hydrostatic tank with a wedge",
                  "The same with a wedge on the floor, half of the depth high. Its faces cut through the rows of particles, so that the water "
                  "beside them starts in disorder and goes on finding a better arrangement: the bar of the speed is fifty times that of the tank.")
    _stillness(study, check, "cases/checks/tank-with-wedge.toml", _level_over_wedge, _wedge_area, 5e-3)
    return check


def two_pools(study):
    check = Check("two_pools", "A wall between two pools",
                  "Water of its own viscosity, 300 mm before a wall and 100 mm behind it, with the default numerics: upright faces alone, which cut no rows, and still the square lattice "
                  "gives way. Force on the wall: that of the two triangles of pressure. Snapshots of each 0.1 s.")
    case = "cases/checks/two-pools.toml"
    flow = study.run(check.name, case)
    largest, rms = flow.speeds(5.0, 10.1)
    check.norm("largest speed of any particle, 5 to 10 s, over √(gH)", largest, 1e-2, "", 3)
    check.norm("rms of the speeds, 5 to 10 s, over √(gH)", rms, 2e-3, "", 3)
    forces = flow.forces
    late = forces["time"] > 5.0
    exact_force = 0.5 * flow.density * flow.gravity_z * (0.3**2 - 0.1**2)
    force = forces["solid_force_1"][late]
    check.norm("force on the wall against that of the two pools", force.mean() / exact_force - 1, 0.01)
    check.norm("standard deviation of that force, over it", force.std() / exact_force)
    figure = figures.Figure(2)
    axes = figure.panel("time t (s)", "force on the wall (N/m)", "")
    figures.exact(axes, forces["time"][[0, -1]], [exact_force, exact_force], "ρg(h₁² − h₂²)/2")
    figures.simulated(axes, forces["time"], forces["solid_force_1"], "particles")
    _speed_panel(figure, _largest_speeds(flow), math.sqrt(flow.gravity_z * flow.depth), 1e-2, 5.0)
    check.figures.append((figure.svg(check.name), "Force on the wall, and the largest speed, against time."))
    if not study.quick:
        compare_options(study, check, case, {
            "correction of each moment": {"numerics.pressure_correction_time": '"0 s"'},
            "square lattice, h = 1.5 dx": {"start.lattice": "square"},
            "square lattice, h = 1.5 dx, correction of each moment": {"start.lattice": "square", "numerics.pressure_correction_time": '"0 s"'}},
            flow, lambda f: f.speeds(5.0, 10.1)[0], "largest speed / √(gH), 5 to 10 s")
    check.best, check.cost = options_text(flow), flow.cost_text
    check.budgets_of(flow, energy=False)
    return check


def beach_at_rest(study):
    check = Check("beach_at_rest", "Still water on a beach",
                  "A beach of 1:5 in a closed tank, whose face cuts the rows of particles at a small angle, and water of its own viscosity. The start "
                  "is packed, and the pressure corrected by the mean of the correction; without, the water creeps up the beach. Snapshots of each 0.1 s.")
    case, interval = "cases/checks/beach-at-rest.toml", {"output.snapshot_interval": '"0.1 s"'}
    flow = study.run(check.name, case, interval)
    largest, rms = flow.speeds(5.0, 6.1)
    check.norm("largest speed of any particle, 5 to 6 s, over √(gH)", largest, 1e-2, "", 3)
    check.norm("rms of the speeds, 5 to 6 s, over √(gH)", rms, 2e-3, "", 3)
    if not study.quick:
        later = study.run(f"{check.name}-longer", case, {**interval, "run.until": '"30 s"'})
        largest, rms = later.speeds(9.0, 30.1)
        check.norm("largest speed, 9 to 30 s", largest, 1e-2, "", 3)
        check.norm("rms, 9 to 30 s", rms, 2e-3, "", 3)
        table = Table(f"{check.title}, 5 to 6 s", ["choice", "largest speed / √(gH)", "rms"])
        for name, settings in {
                "correction of each moment": {"numerics.pressure_correction_time": '"0 s"'},
                "start not packed": {"start.packed": "false"},
                "neither": {"start.packed": "false", "numerics.pressure_correction_time": '"0 s"'},
                "mean of 10 s": {"numerics.pressure_correction_time": '"10 s"'},
                "symmetric form": {"numerics.pressure_form": '"symmetric"', "numerics.pressure_correction_time": '"0 s"'},
                "square lattice, h = 1.5 dx": {"start.lattice": '"square"', "numerics.smoothing_ratio": "1.5"},
                "reference pressure": {"numerics.reference_pressure": "hydrostatic"},
                "reference pressure, correction of each moment": {"numerics.reference_pressure": "hydrostatic",
                                                                  "numerics.pressure_correction_time": '"0 s"'}}.items():
            largest, rms = study.run(f"{check.name}-{len(table.rows)}", case, {**interval, **settings}).speeds(5.0, 6.1)
            table.rows.append([name, f"{largest:.3g}", f"{rms:.2g}"])
        check.tables.append(table)
    check.best, check.cost = options_text(flow), flow.cost_text
    return check


def _level_over_wedge(flow, centre):
    """H of the water over a triangle of area A, centroid z_A, whose centre of mass is at `centre`: L H^2/2 - A z_A = centre (L H - A)."""
    centroid = numpy.mean(flow.parameters["solid"][0]["z"])
    return centre + math.sqrt(centre**2 - 2 * _wedge_area(flow) * (centre - centroid) / flow.length)


def _wedge_area(flow):
    solid = flow.parameters["solid"][0]
    x, z = numpy.array(solid["x"]), numpy.array(solid["z"])
    return 0.5 * abs((x * numpy.roll(z, -1) - z * numpy.roll(x, -1)).sum())


def wave(study):
    check = Check("standing_wave", "Standing gravity wave",
                  "One wave length over the reach; exact: the damped wave of small amplitude with its surface free of traction "
                  "(to all orders in ν), and ω² = gk tanh kH without viscosity.")
    case, interval = "cases/checks/standing-wave.toml", {"output.snapshot_interval": '"10 ms"', "run.until": '"2.2 s"'}

    def measure(flow):
        k = 2 * math.pi / flow.length
        form = flow.parameters["numerics"]["viscosity"]
        frequency, decay = exact.viscous_wave(flow.gravity_z, k, flow.depth, flow.viscosity,
                                              "traction" if form == "monaghan-gingold" else "gradient")
        time, value = numpy.array([(s.time, 2 * (flow.mass * s.z * numpy.cos(k * s.x)).sum() / flow.mass.sum()) for s in flow.snapshots()]).T
        return (frequency, decay), exact.fit_oscillation(time, value, frequency, decay), time, value, exact.gravity_wave(flow.gravity_z, k, flow.depth)

    flow = study.run(check.name, case, interval)
    theory, fit, time, value, inviscid = measure(flow)
    check.norm("period against the viscous wave", theory[0] / fit[0] - 1, 0.01)
    check.norm("period against 2π/√(gk tanh kH)", inviscid / fit[0] - 1, 0.01)
    check.norm("decay against the viscous wave", fit[1] / theory[1] - 1, 0.05)
    water = study.run(f"{check.name}-water", case, {**interval, "fluid.kinematic_viscosity": "1e-6"})
    _, fit_water, *_, inviscid_water = measure(water)
    check.norm("the same with the viscosity of water: period", inviscid_water / fit_water[0] - 1, 0.01)
    check.norm("its decay, 1/s (theory 0.002: what is more is the scheme's)", fit_water[1], 0.04, "1/s")
    check.best, check.cost = options_text(flow), flow.cost_text
    check.budgets_of(flow, energy=False)
    e = check.energy_budget(flow, 111)  # the work of viscosity swings twice a period
    water_energy = Check("", "", "").energy_budget(water, 111)
    figure = figures.Figure(2)
    axes = figure.panel("time t (s)", "first mode of the surface (mm)")
    line = numpy.linspace(0, time[-1], 400)
    scale = flow.parameters["start"]["amplitude"]
    # The first mode of the particles' heights starts at the amplitude's share (1 - what the wave moves below); scaled to it.
    figures.exact(axes, line, 1e3 * scale * numpy.exp(-theory[1] * line) * numpy.cos(theory[0] * line), "exact")
    figures.simulated(axes, time, 1e3 * scale * value / value[0], "particles")
    axes = figure.panel("time t (s)", "energy / first kinetic maximum")
    unit = e.kinetic.max()
    figures.simulated(axes, e.time, (e.total - e.total[0]) / unit, "kinetic + potential + elastic")
    figures.exact(axes, e.time, -e.dissipation / unit, "less the work of viscosity")
    figures.simulated(axes, water_energy.time, (water_energy.total - water_energy.total[0]) / water_energy.kinetic.max(), "viscosity of water", figures.COLOURS[1])
    check.figures.append((figure.svg(check.name), "First mode (exact: line) and the energy that is gone, against the work of viscosity."))
    if not study.quick:
        error = lambda f: (lambda theory, fit, *_: abs(theory[0] / fit[0] - 1))(*measure(f))
        refinement(study, check, case, ("4 mm", "2 mm"), error, "error of the period", interval)
        compare_options(study, check, case, {
            "h = 1.5 dx": {"numerics.smoothing_ratio": "1.5", "numerics.wall_layers": "3"},
            "Morris' viscosity (against its own wave)": {"numerics.viscosity": "morris"},
            "symmetric pressure form": {"numerics.pressure_form": "symmetric"}}, flow, error, "error of the period", interval)
    return check


def sloshing(study):
    check = Check("sloshing", "Sloshing",
                  "Water of even depth in a closed tank on a slope of 2 %: its surface is 4 mm out of level at the ends and swings in the "
                  "modes cos(nπx/L), n odd, ω² = gk tanh kH. The centre of mass tells the first mode (the third has 1/81 of its share).")
    flow = study.run(check.name, "cases/checks/sloshing.toml")
    slope = flow.parameters["channel"]["slope"]
    omega = exact.gravity_wave(flow.gravity_z, math.pi / flow.length, flow.depth)
    time, place = numpy.array([(s.time, (flow.mass * s.x).sum() / flow.mass.sum()) for s in flow.snapshots()]).T
    frequency, decay, fit = exact.fit_oscillation(time, place, omega, 0.02, offset=True)
    n, amplitudes = exact.tilted_tank(slope, flow.length, flow.depth, flow.gravity_z, flow.viscosity, time)
    shift = amplitudes @ (-2 * flow.length / ((n * math.pi) ** 2 * flow.depth))
    equilibrium = 0.5 * flow.length + slope * flow.length**2 / (12 * flow.depth)
    first = time <= 3 * 2 * math.pi / omega
    check.norm("period of the first mode", omega / frequency - 1, 0.01)
    check.norm("centre of mass against the modes' sum over three periods, rms over its amplitude",
               math.sqrt(numpy.mean((place - equilibrium - shift)[first] ** 2)) / abs(shift[0]), 0.05)
    check.norm("decay of the first mode, 1/s (2νk²: {:.3f})".format(2 * flow.viscosity * (math.pi / flow.length) ** 2), decay, None, "1/s")
    check.best, check.cost = options_text(flow), flow.cost_text
    figure = figures.Figure(2)
    axes = figure.panel("time t (s)", "centre of mass x − L/2 (mm)")
    figures.exact(axes, time, 1e3 * (equilibrium + shift - 0.5 * flow.length), "modes")
    figures.simulated(axes, time, 1e3 * (place - 0.5 * flow.length), "particles")
    e = check.energy_budget(flow, 101)
    axes = figure.panel("time t (s)", "energy / largest kinetic energy")
    gone = e.total - e.total[0] - e.weight
    figures.simulated(axes, e.time, gone / e.kinetic.max(), "particles")
    figures.exact(axes, e.time, -e.dissipation / e.kinetic.max(), "less the work of viscosity")
    check.figures.append((figure.svg(check.name), "Centre of mass along the tank, and the energy that is gone."))
    check.budgets_of(flow, energy=False)
    if not study.quick:
        def error(f):
            t, x = numpy.array([(s.time, (f.mass * s.x).sum() / f.mass.sum()) for s in f.snapshots()]).T
            return abs(omega / exact.fit_oscillation(t, x, omega, 0.02, offset=True)[0] - 1)
        refinement(study, check, "cases/checks/sloshing.toml", ("8 mm", "4 mm"), error, "error of the period", {"output.snapshot_interval": '"40 ms"'})
        compare_options(study, check, "cases/checks/sloshing.toml", {
            "h = 1.5 dx": {"numerics.smoothing_ratio": "1.5", "numerics.wall_layers": "3"},
            "Morris' viscosity": {"numerics.viscosity": "morris"}}, flow, error, "error of the period")
        water = study.run(f"{check.name}-viscosity-of-water", "cases/checks/sloshing.toml", {"fluid.kinematic_viscosity": "1e-6"})
        check.norm("the same with the viscosity of water", error(water), 0.01)
    return check


def write_drop(path, template, radius, rate, spacing, depth, density, sound_speed):
    """A results file with the state of the drop: rings of particles of equal area, its velocity and its pressure.

    The pressure of the ideal fluid at the start is rho A^2 (R^2 - r^2)/2."""
    centre_x, centre_z = 3.0 * radius, 0.5 * depth
    rings = round(radius / spacing)
    x, z = [], []
    for ring in range(rings):
        # Ring j between radii j and j + 1 spacings holds its share of particles of one spacing squared: pi (2 j + 1).
        count = max(round(math.pi * (2 * ring + 1)), 1)
        angle = 2 * math.pi * (numpy.arange(count) + 0.5 * (ring % 2)) / count
        r = 0.0 if ring == 0 and count == 1 else (ring + 0.5) * radius / rings
        x.append(r * numpy.cos(angle))
        z.append(r * numpy.sin(angle))
    x, z = numpy.concatenate(x), numpy.concatenate(z)
    area = math.pi * radius**2 / x.size
    pressure = 0.5 * density * rate**2 * (radius**2 - x**2 - z**2)
    deviation = pressure / (density * sound_speed**2)
    with h5py.File(path, "w") as file:
        file.attrs.update({"format": numpy.bytes_("riffle-results"), "format_version": 1, "dimension": 2, "complete": 1})
        file.create_dataset("/case/text", data=template)
        state = file.create_group("state")
        state.attrs["sound_speed"] = sound_speed
        for name, values in {"position_x": x + centre_x, "position_z": z + centre_z, "velocity_x": rate * x, "velocity_z": -rate * z,
                             "density_deviation": deviation, "mass": density * (1 + deviation) * area}.items():
            state[name] = values.astype(float)
        state["id"] = numpy.arange(x.size, dtype=numpy.int64)
    return centre_x, centre_z


def drop(study):
    check = Check("drop", "Elliptic drop",
                  "A weightless drop, a circle with the velocity A(x, −z), becomes an ellipse whose axes follow an ordinary differential "
                  "equation (Monaghan 1994). No gravity, no wall: free surface, pressure and momentum alone.")
    radius, rate, case = 1.0, 1.0, "tests/verification/elliptic-drop.toml"

    def axes_of(flow):
        rows = []
        for s in flow.snapshots():
            m = flow.mass
            cx, cz = (m * s.x).sum() / m.sum(), (m * s.z).sum() / m.sum()
            # Of a uniform ellipse the second moments are a^2 / 4 and b^2 / 4.
            rows.append((s.time, 2 * math.sqrt((m * (s.x - cx) ** 2).sum() / m.sum()), 2 * math.sqrt((m * (s.z - cz) ** 2).sum() / m.sum()),
                         (m * (s.u * (s.z - cz) - s.w * (s.x - cx))).sum(), (m * (s.u**2 + s.w**2)).sum() / 2))
        return numpy.array(rows)

    def run(spacing, name, more=None):
        start = study.folder / f"drop-{spacing:g}.h5"
        template = f'[channel]\nslope = 0.0\ndepth = 3.0\nlength = 6.0\n[bed]\nkind = "slip"\n[turbulence]\nclosure = "none"\n' \
                   f'[fluid]\ngravity = 1e-6\n[numerics]\nspacing = {spacing}\nsound_speed = 20.0\n[start]\nkind = "rest"\n[run]\nuntil = 1.0\n'
        write_drop(start, template, radius, rate, spacing, 3.0, 1000.0, 20.0)
        return study.run(name, case, {"start.file": f'"{start.resolve()}"', "numerics.spacing": repr(spacing), **(more or {})})

    def error(flow):
        rows = axes_of(flow)
        a, b, _ = exact.elliptic_drop(radius, rate, rows[:, 0])
        # From the axes at the start, which the arrangement of the particles gives to a part in a thousand.
        return numpy.abs(rows[:, 1] / rows[0, 1] - a / a[0]).max(), numpy.abs(rows[:, 2] / rows[0, 2] - b / b[0]).max()

    spacing = 0.05 if study.quick else 0.025
    flow = run(spacing, check.name)
    rows = axes_of(flow)
    a, b, r = exact.elliptic_drop(radius, rate, rows[:, 0])
    long_error, short_error = error(flow)
    check.norm("long semi-axis up to At = 1, largest error over R", long_error, 0.02)
    check.norm("short semi-axis, the same", short_error, 0.02)
    unit = (flow.mass * ((flow.snapshot(0).x - 3) ** 2 + (flow.snapshot(0).z - 1.5) ** 2)).sum() * rate
    check.norm("change of angular momentum (exact: none), over the moment of inertia times A", (rows[-1, 3] - rows[0, 3]) / unit)
    exact_energy = 0.5 * flow.mass.sum() / 4 * r**2 * (a**2 + b**2)
    check.norm("kinetic energy in the end against the exact (potential flow: constant)", rows[-1, 4] / exact_energy[-1] - 1)
    check.best, check.cost = options_text(flow), flow.cost_text
    figure = figures.Figure(2)
    axes = figure.panel("time A t", "semi-axes / R")
    figures.exact(axes, rows[:, 0] * rate, a, "exact")
    figures.exact(axes, rows[:, 0] * rate, b)
    figures.simulated(axes, rows[:, 0] * rate, rows[:, 1] / rows[0, 1], "long")
    figures.simulated(axes, rows[:, 0] * rate, rows[:, 2] / rows[0, 2], "short", figures.COLOURS[1])
    axes = figure.panel("x / R", "z / R", "particles and the exact ellipse at the end")
    last, turn = flow.snapshot(-1), numpy.linspace(0, 2 * math.pi, 200)
    figures.exact(axes, a[-1] * numpy.cos(turn), b[-1] * numpy.sin(turn))
    figures.simulated(axes, last.x - 3, last.z - 1.5, most=700)
    axes.set_aspect("equal")
    check.figures.append((figure.svg(check.name), "Semi-axes (from the second moments), and the drop at the end."))
    check.budgets_of(flow)
    if not study.quick:
        errors, table_rows = [], []
        for dx in (0.1, 0.05, 0.025):
            other = run(dx, f"{check.name}-{dx}")
            errors.append(max(error(other)))
            table_rows.append([f"R/{radius / dx:.0f}", f"{100 * errors[-1]:.3g}", f"{other.cost:.1f}"])
        check.tables.append(study.table(f"{check.title}: spacings (observed order {exact.observed_order([0.1, 0.05, 0.025], errors):.2f})",
                                        ["spacing", "largest error of an axis / R %", "s of a core"], table_rows))
    return check


def _front(flow, s, drops=2):
    """Place of the foremost particle in the lowest two rows, but for a few drops that run ahead; its half spacing belongs to the water."""
    low = numpy.sort(s.x[s.z < 2 * flow.spacing])
    return low[-1 - drops] + 0.5 * flow.spacing


def _depths(flow, s, edges):
    volume = flow.mass / s.density
    return numpy.histogram(s.x, bins=edges, weights=volume)[0] / numpy.diff(edges)


def dam_break(study):
    check = Check("dam_break", "Dam break on a dry bed",
                  "Ritter (1892): h = (2√(gh<sub>0</sub>) − x/t)²/(9g). Shallow water leaves out the vertical acceleration, so the water of two "
                  "dimensions starts late and its front stays behind by a constant way: speed and depths are compared.")
    flow = study.run(check.name, "cases/checks/dam-break.toml", {"output.snapshot_interval": '"10 ms"'})
    h0, dam = flow.depth, max(flow.parameters["start"]["water_x"])
    c = math.sqrt(flow.gravity_z * h0)
    fronts = numpy.array([(s.time, _front(flow, s)) for s in flow.snapshots()])
    at = lambda t: numpy.interp(t, fronts[:, 0], fronts[:, 1])
    early, late = 3 * h0 / c, 6 * h0 / c
    check.norm("speed of the front, t√(g/h₀) from 3 to 6, against 2√(gh₀)", (at(late) - at(early)) / (late - early) / (2 * c) - 1, 0.05)
    s = flow.snapshot(int(numpy.argmin(numpy.abs(flow.snapshot_time - late))))
    edges = numpy.arange(dam - c * s.time, dam + 1.5 * c * s.time, 4 * flow.spacing)
    middle = 0.5 * (edges[1:] + edges[:-1]) - dam
    depth = _depths(flow, s, edges)
    check.norm("rms of the depth, x/t from −1 to 1.5 √(gh₀), over h₀", math.sqrt(numpy.mean((depth - exact.ritter_depth(flow.gravity_z, h0, middle, s.time)) ** 2)) / h0, 0.05)
    check.norm("depth at the dam's place against 4h₀/9, over h₀", numpy.interp(0.0, middle, depth) / h0 - 4 / 9, 0.05)
    check.norm("way that the front is behind, over 2√(gh₀) t", 1 - (at(late) - dam) / (2 * c * late))
    check.best, check.cost = options_text(flow), flow.cost_text
    figure = figures.Figure(2)
    axes = figure.panel("place x / h₀ from the dam", "depth h / h₀", f"t √(g/h₀) = {s.time * c / h0:.2g}")
    line = numpy.linspace(-1.3 * c * s.time, 2.1 * c * s.time, 300)
    figures.exact(axes, line / h0, exact.ritter_depth(flow.gravity_z, h0, line, s.time) / h0, "Ritter")
    wide = numpy.arange(0, flow.length, 4 * flow.spacing)
    all_depths = _depths(flow, s, wide)
    wet = all_depths > 0
    figures.simulated(axes, ((0.5 * (wide[1:] + wide[:-1]) - dam) / h0)[wet], all_depths[wet] / h0, "volume of the particles")
    axes = figure.panel("time t √(g/h₀)", "front x / h₀ from the dam")
    figures.exact(axes, fronts[:, 0] * c / h0, 2 * c * fronts[:, 0] / h0, "2 √(g h₀) t")
    figures.simulated(axes, fronts[:, 0] * c / h0, (fronts[:, 1] - dam) / h0, "particles")
    check.figures.append((figure.svg(check.name), "Depth along the channel and the place of the front."))
    check.budgets_of(flow)
    return check


def collapse(study):
    check = Check("collapse", "Collapse of a column of water",
                  "Martin &amp; Moyce (1952), a = 2.25 in, n² = 2: front over the dry floor and height at the wall. The water of the experiment "
                  "comes late by nearly one time wherever it is looked at (its column stood behind waxed paper that took a moment to go): one "
                  "lag is fitted, and what remains is compared.")
    flow = study.run(check.name, "cases/checks/column-collapse.toml", {"output.snapshot_interval": '"2 ms"'})
    a = max(flow.parameters["start"]["water_x"])
    unit = math.sqrt(a / (2 * flow.gravity_z))
    rows = []
    for s in flow.snapshots():
        wall = s.z[s.x < 2 * flow.spacing]
        rows.append((s.time / unit, _front(flow, s) / a, (wall.max() + 0.5 * flow.spacing) / (2 * a)))
    time, front, height = numpy.array(rows).T
    measured_t, measured_z = exact.MARTIN_MOYCE_FRONT.T
    lag = numpy.mean(measured_t - numpy.interp(measured_z, numpy.maximum.accumulate(front), time))
    error = numpy.abs(numpy.interp(measured_t - lag, time, front) / measured_z - 1)
    check.norm("front after one lag, largest error over its place", error.max(), 0.05)
    check.norm("that lag, in √(a/2g)", lag, None, "")
    height_t, height_h = exact.MARTIN_MOYCE_HEIGHT.T
    check.norm("height at the wall, largest error over 2a", numpy.abs(numpy.interp(height_t, time / math.sqrt(2), height) - height_h).max(), 0.05)
    check.best, check.cost = options_text(flow), flow.cost_text
    figure = figures.Figure(2)
    axes = figure.panel("time t √(2g/a)", "front x / a")
    figures.exact(axes, measured_t, measured_z, "Martin & Moyce", marker="s", markersize=3)
    figures.exact(axes, measured_t - lag, measured_z, "the same, less the lag", marker="s", markersize=3, linestyle=":")
    figures.simulated(axes, time, front, "particles")
    axes = figure.panel("time t √(g/a)", "height at the wall h / 2a")
    figures.exact(axes, height_t, height_h, "Martin & Moyce", marker="s", markersize=3)
    figures.simulated(axes, time / math.sqrt(2), height, "particles")
    check.figures.append((figure.svg(check.name), "Front and height at the wall; squares are the measurements."))
    check.budgets_of(flow)
    return check


def step(study):
    check = Check("step", "Flow over a step",
                  "Water driven over a step in a periodic channel: in the mean the same discharge passes every section, and the force on the "
                  "walls carries the weight component.")
    flow = study.run(check.name, "cases/checks/flow-over-step.toml", {"output.snapshot_interval": '"0.05 s"'})
    late = [s for s in flow.snapshots() if s.time > 0.5 * flow.values["simulated_time"]]
    edges = numpy.linspace(0, flow.length, 25)
    discharge = numpy.zeros(24)
    for s in late:
        discharge += numpy.histogram(s.x, bins=edges, weights=flow.mass / s.density * s.u)[0] / numpy.diff(edges) / len(late)
    check.norm("mean discharge of 24 sections, rms of the departure over the mean", discharge.std() / discharge.mean(), 0.01)
    times = flow.forces["time"]
    inside = times > 0.5 * flow.values["simulated_time"]
    momentum = [(flow.mass * s.u).sum() for s in (late[0], late[-1])]
    weight = flow.forces["weight_component"][inside].mean()
    rate = (momentum[1] - momentum[0]) / (late[-1].time - late[0].time)
    check.norm("mean force on bed and step plus rate of change of momentum, over the weight component, less 1",
               (flow.forces["wall_force"][inside].mean() + rate) / weight - 1, 0.01)
    check.best, check.cost = options_text(flow), flow.cost_text
    figure = figures.Figure(2)
    axes = figure.panel("place x (m)", "height z (m)", "stream at the end, speed in colour")
    s = late[-1]
    drawn = axes.scatter(s.x, s.z, c=numpy.hypot(s.u, s.w), s=9, cmap="viridis", linewidths=0)
    figure.figure.colorbar(drawn, ax=axes, label="m/s")
    axes = figure.panel("place x (m)", "mean discharge / its mean")
    figures.exact(axes, edges[[0, -1]], [1, 1], "exact")
    figures.simulated(axes, 0.5 * (edges[1:] + edges[:-1]), discharge / discharge.mean(), "sections")
    check.figures.append((figure.svg(check.name), "The stream over the step and the discharge through its sections."))
    check.budgets_of(flow)
    return check


CHECKS = {"tank": tank, "wedge": wedge, "two_pools": two_pools, "beach_at_rest": beach_at_rest, "standing_wave": wave, "sloshing": sloshing, "drop": drop, "dam_break": dam_break,
          "collapse": collapse, "step": step}
