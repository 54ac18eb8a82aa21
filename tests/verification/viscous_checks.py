"""Laminar and turbulent flows whose velocity is known: between plates, in channels, vortices, a cavity."""

import math

import numpy

import exact
import figures
from check import Check
from flow import Energy
from options import compare_options, options_text, refinement


def _transient_error(flow, solution, scale, earliest):
    """Largest and rms error of u over the particles of all snapshots from `earliest` on, over `scale`."""
    largest, squares, count = 0.0, 0.0, 0
    for s in flow.snapshots():
        if s.time >= earliest:
            error = (s.u - solution(s.z, s.time)) / scale
            largest, squares, count = max(largest, numpy.abs(error).max()), squares + (error**2).sum(), count + error.size
    return largest, math.sqrt(squares / count)


def _profiles_figure(flow, solution, times, scale, x_label, name, caption):
    figure = figures.Figure(1, width=5.2)
    axes = figure.panel(x_label, "height z / H")
    z = numpy.linspace(0, flow.depth, 200)
    shots = {t: min(range(len(flow.names)), key=lambda i: abs(flow.snapshot_time[i] - t)) for t in times}
    for colour, (t, index) in zip(figures.COLOURS, shots.items()):
        s = flow.snapshot(index)
        figures.exact(axes, solution(z, s.time) / scale, z / flow.depth, colour=colour)
        order = numpy.argsort(s.z)
        figures.simulated(axes, s.u[order] / scale, s.z[order] / flow.depth, f"t = {s.time:.4g} s", colour)
    return figure.svg(name), caption


def _plates(study, check, case, solution_of, scale_of, label, spacings):
    """Poiseuille and Couette flow: the whole transient, options and spacings."""
    def measure(flow):
        solution = solution_of(flow)
        return _transient_error(flow, solution, scale_of(flow), 0.01 * flow.depth**2 / flow.viscosity)

    flow = study.run(check.name, case)
    largest, rms = measure(flow)
    check.norm(f"largest error of u of any particle from 0.01 to {flow.values['simulated_time'] * flow.viscosity / flow.depth**2:.2g} L²/ν, over {label}",
               largest, 0.01)
    check.norm("rms of the same", rms)
    check.best, check.cost = options_text(flow), flow.cost_text
    check.figures.append(_profiles_figure(
        flow, solution_of(flow), [0.0225, 0.045, 0.1125, 0.225, 1.0], scale_of(flow), f"velocity u / {label}", check.name,
        "Velocity between the plates at the times of Morris, Fox & Zhu (1997) and in the end: series (lines) and particles (points)."))
    lid = flow.parameters["channel"].get("lid_velocity", 0.0)
    check.budgets_of(flow, vertical=False, energy=lid == 0.0)
    if lid:
        rate = Energy(flow, 2).rate[-1] / (flow.density * flow.viscosity * lid**2 / flow.depth * flow.length)
        check.budget("energy", f"{rate - 1:+.1e}", "work of viscosity in the end against that of the lid, μV₀²/L per area, less 1")
    if not study.quick:
        refinement(study, check, case, spacings, lambda f: measure(f)[1], f"rms error of u / {label}")
        compare_options(study, check, case, {
            "h = 2 dx": {"numerics.smoothing_ratio": "2", "numerics.wall_layers": "4"},
            "viscosity along the line of centres": {"numerics.viscosity": "monaghan-gingold"},
            "cubic spline": {"numerics.kernel": "cubic-spline"},
            "quintic spline, h = 2 dx": {"numerics.kernel": "quintic-spline", "numerics.smoothing_ratio": "2", "numerics.wall_layers": "4"},
            "predictor-corrector": {"numerics.stepping": "predictor-corrector"}},
            flow, lambda f: measure(f)[0], f"largest error of u / {label}")
    return check


def poiseuille(study):
    check = Check("poiseuille", "Poiseuille start-up",
                  "Flow between two plates from rest, with the parameters of Morris, Fox &amp; Zhu (1997); exact: a Fourier series.")
    return _plates(study, check, "cases/checks/poiseuille.toml",
                   lambda f: lambda z, t: exact.poiseuille_start(f.gravity_x, f.viscosity, f.depth, z, t),
                   lambda f: f.gravity_x * f.depth**2 / (8 * f.viscosity), "U_max", ("40 um", "20 um", "10 um"))


def couette(study):
    check = Check("couette", "Couette start-up",
                  "One plate begins to move at once, with the parameters of Morris, Fox &amp; Zhu (1997); exact: a Fourier series.")
    lid = lambda f: f.parameters["channel"]["lid_velocity"]
    return _plates(study, check, "cases/checks/couette.toml",
                   lambda f: lambda z, t: exact.couette_start(lid(f), f.viscosity, f.depth, z, t), lid, "V_0",
                   ("40 um", "20 um", "10 um"))


def laminar(study, reynolds):
    """Federico et al. (2012), the whole transient from a uniform velocity."""
    check = Check(f"laminar_re{reynolds}", f"Laminar channel, Re {reynolds}",
                  "Open channel of Federico, Marrone, Colagrossi, Aristodemo &amp; Antuono (2012) from a uniform velocity; exact: a "
                  "Fourier series that ends in the parabola g S<sub>0</sub>/(2ν) (2hz − z²).")
    flow = study.run(check.name, f"cases/checks/laminar-re{reynolds}.toml")
    start, scale = flow.parameters["start"]["velocity"], flow.gravity_x * flow.depth**2 / (2 * flow.viscosity)
    solution = lambda z, t: exact.channel_start(flow.gravity_x, flow.viscosity, flow.depth, start, z, t)
    relaxation = 4 * flow.depth**2 / (math.pi**2 * flow.viscosity)
    errors = [math.sqrt(numpy.mean((s.u - solution(s.z, s.time)) ** 2)) / scale for s in flow.snapshots()
              if s.time > 0.01 * flow.depth**2 / flow.viscosity]
    last = flow.snapshot(-1)
    check.norm("rms of u(z), worst of all snapshots over "
               f"{flow.values['simulated_time'] / relaxation:.1f} relaxation times, over U_max", max(errors), 0.01)
    check.norm("mean velocity in the end", last.u.mean() / solution(last.z, last.time).mean() - 1, 0.01)
    top = last.z > last.z.max() - 0.5 * flow.spacing
    check.norm("surface velocity in the end", last.u[top].mean() / solution(last.z[top], last.time).mean() - 1, 0.01)
    check.norm("drift of the depth over the run, over the depth", flow.mean_height[-1] / flow.mean_height[0] - 1)
    check.best, check.cost = options_text(flow), flow.cost_text
    times = [0.05 * relaxation, 0.3 * relaxation, relaxation, flow.values["simulated_time"]]
    check.figures.append(_profiles_figure(flow, solution, times, scale, "velocity u / U_max", check.name,
                                          "Velocity over the depth: series (lines) and particles (points)."))
    check.budgets_of(flow)
    return check


def laminar_10(study):
    return laminar(study, 10)


def laminar_100(study):
    return laminar(study, 100)


def laminar_200(study):
    return laminar(study, 200)


def film(study):
    """Meister's film of water: as he had it, and with the weight across it a hundredth."""
    check = Check("laminar_water", "Laminar film of water (Re 798)",
                  "29 mm of water on a slope of 1e-5 (Meister, Burger &amp; Rauch 2014, where the flow of SPH drifted away), started from "
                  "its exact parabola, which it must keep over a relaxation time, 4h²/(π²ν) = 341 s. <strong>Riffle drifts here too.</strong> "
                  "The pressure forces are a hundred thousand times the weight component, so slow a shear gives the "
                  "rows of particles time to leave their order, as they do in still water, and the viscosity of water does not stop them. Among "
                  "disordered particles the two-point viscosity is too small, and without any other viscosity the depth grows by a percent in a "
                  "hundred seconds, the velocity by twice that (u ~ h²). Both fall with the spacing. The usual pair forms do worse by far: "
                  "their spurious friction stops the flow (table of option sets). The same film (Reynolds number, weight component, viscosity) with a hundredth of the gravity "
                  "on a hundred times the slope and h = 3 dx does not drift (with h = 2 dx it keeps the order of its particles, and the parabola to 0.2 %, "
                  "for 190 s, and then drifts by 0.7 % in 100 s). A turbulent channel has a thousand times this viscosity and does not drift (validation).")
    case = "cases/checks/laminar-water.toml"
    scale_of = lambda f: f.gravity_x * f.depth**2 / (2 * f.viscosity)
    solution = lambda f, z: f.gravity_x / (2 * f.viscosity) * z * (2 * f.depth - z)

    def history(f):
        """Time, departure of the mean velocity, rms of single particles and of w over U_max."""
        scale = scale_of(f)
        return numpy.array([(s.time, s.u.mean() / (2 / 3 * scale) - 1, math.sqrt(numpy.mean((s.u - solution(f, s.z)) ** 2)) / scale,
                             math.sqrt(numpy.mean(s.w**2)) / scale) for s in f.snapshots()])

    def profile(f):
        """Layers' heights and mean velocities over U_max, over the second half of the run."""
        shots = [f.snapshot(i) for i in range(len(f.names) // 2, len(f.names))]
        z, u = numpy.concatenate([s.z for s in shots]), numpy.concatenate([s.u for s in shots])
        index = numpy.clip((z / f.depth * 15).astype(int), 0, 14)
        count = numpy.bincount(index, minlength=15)
        return numpy.bincount(index, weights=z) / count / f.depth, numpy.bincount(index, weights=u) / count / scale_of(f)

    light = study.run(f"{check.name}-light", case, {"channel.slope": "1e-3", "fluid.gravity": "0.0981", "numerics.smoothing_ratio": "3",
                                                    "numerics.wall_layers": "6", "channel.length": '"16 mm"'})
    own = study.run(check.name, case)
    figure = figures.Figure(2)
    profiles = figure.panel("velocity u / U_max", "height z / H", "mean of the second half of the run")
    drift = figure.panel("time t (s)", "mean velocity / exact − 1 (%)")
    for flow, label, colour in ((light, "g/100, slope 1e-3, h = 3 dx", figures.COLOURS[0]), (own, "g, slope 1e-5", figures.COLOURS[1])):
        rows = history(flow)
        heights, means = profile(flow)
        check.norm(f"mean velocity, largest departure in {rows[-1, 0]:.0f} s; {label}", numpy.abs(rows[:, 1]).max(), 0.01)
        error = means - solution(flow, heights * flow.depth) / scale_of(flow)
        check.norm(f"profile of the layers, mean of the second half of the run, rms over U_max; {label}", math.sqrt(numpy.mean(error**2)), 0.01)
        check.norm(f"scatter of single particles in the end, rms of u over U_max; {label}", rows[-1, 2])
        check.norm(f"growth of the depth in that time; {label}", flow.mean_height[-1] / flow.mean_height[0] - 1)
        figures.simulated(profiles, means, heights, label, colour)
        figures.simulated(drift, rows[:, 0], 100 * rows[:, 1], label, colour, 60)
    line = numpy.linspace(0, light.depth, 100)
    figures.exact(profiles, solution(light, line) / scale_of(light), line / light.depth, "parabola")
    figures.exact(drift, rows[[0, -1], 0], [0, 0])
    check.best, check.cost = options_text(light), f"{light.cost_text}; with g: {own.cost:.0f} s"
    if not study.quick:
        short = {"run.until": '"40 s"', "run.average_from": '"30 s"', "channel.length": '"16 mm"'}
        compare_options(study, check, case, {
            "h = 3 dx": {"numerics.smoothing_ratio": "3", "numerics.wall_layers": "6"},
            "viscosity along the line of centres": {"numerics.viscosity": "monaghan-gingold"},
            "dx = 0.5 mm": {"numerics.spacing": "0.0005"},
            "symmetric pressure form": {"numerics.pressure_form": "symmetric"},
            "symmetric pressure form, h = 1.5 dx": {"numerics.pressure_form": "symmetric", "numerics.smoothing_ratio": "1.5", "numerics.wall_layers": "3"},
            "Riemann's pressure form": {"numerics.pressure_form": "riemann"}},
            study.run(f"{check.name}-short", case, short), lambda f: abs(history(f)[-1, 1]), "departure of the mean velocity after 40 s, with g,", short)
    check.figures.append((figure.svg(check.name), "Profile against the parabola, and the departure of the mean velocity against time."))
    check.budgets_of(light)
    return check


def ramp(study):
    """The closed profile of the ramp mixing length."""
    check = Check("ramp", "Ramp mixing length over a smooth bed",
                  "With l<sub>m</sub> = min(κz, λH) under the stress ρu<sub>*</sub>²(1 − z/H) the profile is known in closed form but for a "
                  "constant, which is the bed's business: at a no-slip bed with water's viscosity the velocity rises within 0.1 mm, which no "
                  "particle resolves. So the velocity defect is compared, u(H) − u(z), from 0.05 H (below, the rows beside the wall carry "
                  "what it does not resolve); and the column twin, which resolves the wall, shows what the constant should be.")
    flow = study.run(check.name, "cases/checks/ramp-profile.toml")
    friction = math.sqrt(flow.gravity_x * flow.depth)
    shots = [s for s in flow.snapshots() if s.time >= 0.5 * flow.values["simulated_time"]]
    xi = numpy.concatenate([s.z for s in shots]) / flow.depth
    u = numpy.concatenate([s.u for s in shots]) / friction
    rows = round(flow.depth / flow.spacing)
    index = numpy.clip((xi * rows).astype(int), 0, rows - 1)
    count = numpy.bincount(index, minlength=rows)
    height = numpy.bincount(index, weights=xi, minlength=rows) / count
    mean = numpy.bincount(index, weights=u, minlength=rows) / count
    closed = exact.ramp_profile(height)
    inside = height >= 0.05
    shift = numpy.mean((mean - closed)[inside])
    error = (mean - closed - shift)[inside] / exact.ramp_profile(1.0)
    check.norm("rms of the defect profile from 0.05 H to the surface, over U+(1) = 12.38", math.sqrt(numpy.mean(error**2)), 0.02)
    check.norm("largest of the same", numpy.abs(error).max(), 0.02)
    slope = lambda lo, hi: numpy.interp(hi, height, mean) - numpy.interp(lo, height, mean)
    exact_slope = lambda lo, hi: exact.ramp_profile(hi) - exact.ramp_profile(lo)
    check.norm("u(0.2 H) − u(0.05 H), the logarithmic part", slope(0.05, 0.2) / exact_slope(0.05, 0.2) - 1)
    column = float(flow.column["surface_velocity"]) / friction
    check.norm("u(H) against the column twin with its resolved wall", numpy.interp(0.99, height, mean) / (column - exact_slope(0.99, 1.0)) - 1)
    check.best, check.cost = options_text(flow), flow.cost_text
    figure = figures.Figure(1, width=5.2)
    axes = figure.panel("height z / H (logarithmic)", "velocity less a constant, U+")
    axes.set_xscale("log")
    line = numpy.geomspace(0.01, 1, 200)
    figures.exact(axes, line, exact.ramp_profile(line), "closed form")
    figures.simulated(axes, height, mean - shift, "rows of particles")
    check.figures.append((figure.svg(check.name), "Velocity in units of u_*: closed form and the time means of the rows, shifted by one constant."))
    check.budgets_of(flow)
    return check


def _vortices(flow):
    """Rows of time, amplitude over the exact one, L2 error of the velocity over the exact amplitude, kinetic energy over the exact."""
    k, rows = 2 * math.pi / flow.length, []
    for s in flow.snapshots():
        m = flow.mass
        shape_u, shape_w = numpy.sin(k * s.x) * numpy.cos(k * s.z), -numpy.cos(k * s.x) * numpy.sin(k * s.z)
        amplitude = 2 * (m * (s.u * shape_u + s.w * shape_w)).sum() / m.sum()
        decayed = flow.parameters["start"]["velocity"] * math.exp(-2 * flow.viscosity * k**2 * s.time)
        square = (m * ((s.u - decayed * shape_u) ** 2 + (s.w - decayed * shape_w) ** 2)).sum() / m.sum()
        rows.append((s.time, amplitude / decayed, math.sqrt(2 * square) / decayed, (m * (s.u**2 + s.w**2)).sum() / (m.sum() * 0.5 * decayed**2)))
    return numpy.array(rows)


def _rate_error(flow, rows, begin):
    exact_rate = 2 * flow.viscosity * (2 * math.pi / flow.length) ** 2
    inside = rows[:, 0] >= begin
    return -numpy.polyfit(rows[inside, 0], numpy.log(rows[inside, 1]), 1)[0] / exact_rate


def taylor_green(study, reynolds):
    check = Check(f"taylor_green_re{reynolds}", f"Taylor-Green vortices, Re {reynolds}",
                  "Decay of vortices in a periodic box as exp(−2νk²t), from disordered particles (jitter 0.2); the rate from 0.2 s on, "
                  "when they have settled.")
    case = "cases/checks/taylor-green.toml" if reynolds == 100 else "cases/checks/taylor-green-re1000.toml"
    interval = {"output.snapshot_interval": '"0.02 s"' if reynolds == 100 else '"0.2 s"'}
    sides = [32, 64] if study.quick else [32, 64, 100, 128]
    table_rows, spacings, errors, velocity_errors = [], [], [], []
    figure = figures.Figure(2)
    decay = figure.panel("time t (s)", "amplitude / m/s")
    departure = figure.panel("time t (s)", "amplitude / exact − 1 (%)")
    for colour, side in zip(figures.COLOURS, sides):
        flow = study.run(f"{check.name}-{side}", case, {"numerics.spacing": repr(1 / side), **interval})
        rows = _vortices(flow)
        rate, l2 = _rate_error(flow, rows, 0.2), rows[-1, 2]
        spacings.append(1 / side)
        turn = numpy.argmin(numpy.abs(rows[:, 0] - 1.0))  # after L / U, before vortices on few particles break up
        errors.append(abs(rows[turn, 1] - 1))
        velocity_errors.append(rows[turn, 2])
        table_rows.append([side, f"{100 * rate:+.2f}", f"{100 * (rows[-1, 1] - 1):+.2f}", f"{100 * l2:.2f}", f"{flow.cost:.0f}"])
        k2 = (2 * math.pi / flow.length) ** 2
        if side == sides[-1]:
            line = numpy.linspace(0, rows[-1, 0], 100)
            figures.exact(decay, line, numpy.exp(-2 * flow.viscosity * k2 * line), "exact")
            figures.exact(departure, line[[0, -1]], [0, 0])
        figures.simulated(decay, rows[:, 0], rows[:, 1] * numpy.exp(-2 * flow.viscosity * k2 * rows[:, 0]), f"{side} a side", colour, 40)
        figures.simulated(departure, rows[:, 0], 100 * (rows[:, 1] - 1), f"{side} a side", colour)
        if side == (64 if study.quick else 100):
            chosen, chosen_rate, chosen_amplitude, chosen_l2 = flow, rate, rows[-1, 1] - 1, l2
    departure.set_ylim(max(departure.get_ylim()[0], -6), min(departure.get_ylim()[1], 6))
    end = chosen.values["simulated_time"]
    check.norm(f"rate of decay from 0.2 to {end:.3g} s against 2νk², {chosen.length / chosen.spacing:.0f} a side", chosen_rate, 0.03)
    check.norm(f"amplitude at {end:.3g} s, the settling of the start included", chosen_amplitude, 0.03)
    check.norm("L2 error of the velocity at the end, over the amplitude left", chosen_l2)
    if len(sides) > 2:
        check.norm("observed order of the error of the amplitude at 1 s", exact.observed_order(spacings, errors), None, "")
        check.norm("observed order of the velocity's L2 error at 1 s", exact.observed_order(spacings, velocity_errors), None, "")
    check.best, check.cost = options_text(chosen), chosen.cost_text
    table = study.table(f"{check.title}: resolutions", ["a side", "rate %", "amplitude at the end %", "L2 error of the velocity %", "s of a core"], table_rows)
    check.tables.append(table)
    check.figures.append((figure.svg(check.name), "Amplitude of the vortices (projection of the velocity on them), and its departure from the exact decay."))
    e = check.budgets_of(chosen)
    exact_loss = 1 - math.exp(-4 * chosen.viscosity * (2 * math.pi / chosen.length) ** 2 * end)
    check.budget("energy", f"{(e.total[0] - e.total[-1]) / e.kinetic[0]:.4f} (exact {exact_loss:.4f})", "share of the kinetic energy that is gone at the end")
    if not study.quick:
        base = study.run(f"{check.name}-64", case, {"numerics.spacing": repr(1 / 64), **interval})
        variants = {
            "h = 1.5 dx": {"numerics.smoothing_ratio": "1.5"}, "h = 2 dx": {"numerics.smoothing_ratio": "2"},
            "c0 = 20 U": {"numerics.sound_speed": "20"}, "half the Courant number": {"numerics.courant_number": "0.35"},
            "symmetric pressure form": {"numerics.pressure_form": "symmetric"}}
        if reynolds == 100:
            variants |= {"h = 2 dx, Wendland C4": {"numerics.smoothing_ratio": "2", "numerics.kernel": "wendland-c4"},
                         "viscosity along the line of centres": {"numerics.viscosity": "monaghan-gingold"}}
        compare_options(study, check, case, variants,
            base, lambda f: abs(_rate_error(f, _vortices(f), 0.2)), "error of the rate, 64 a side",
            {"numerics.spacing": repr(1 / 64), **interval})
    return check


def taylor_green_100(study):
    return taylor_green(study, 100)


def taylor_green_1000(study):
    return taylor_green(study, 1000)


def _field_at(flow, shots, x, z, component):
    """Mean over snapshots of the velocity at points: a linear least-squares fit weighted by Wendland's kernel."""
    values = numpy.zeros(len(x))
    for s in shots:
        for i, (px, pz) in enumerate(zip(x, z)):
            dx, dz = (s.x - px) / flow.smoothing_length, (s.z - pz) / flow.smoothing_length
            q = numpy.hypot(dx, dz)
            near = q < 2
            weight = numpy.sqrt((1 - q[near] / 2) ** 4 * (2 * q[near] + 1))
            basis = numpy.column_stack([numpy.ones(near.sum()), dx[near], dz[near]]) * weight[:, None]
            values[i] += numpy.linalg.lstsq(basis, getattr(s, component)[near] * weight, rcond=None)[0][0] / len(shots)
    return values


def cavity(study, reynolds):
    check = Check(f"cavity_re{reynolds}", f"Lid-driven cavity, Re {reynolds}",
                  "Velocities on the two centre lines in the steady state, against the tables of Ghia, Ghia &amp; Shin (1982).")
    case = "cases/checks/lid-driven-cavity.toml" if reynolds == 100 else "cases/checks/lid-driven-cavity-re1000.toml"

    def measure(flow, every=None):
        lid = flow.parameters["channel"]["lid_velocity"]
        span = 0.1 * flow.values["simulated_time"]
        shots = [flow.snapshot(i) for i, t in enumerate(flow.snapshot_time) if t > flow.snapshot_time[-1] - span]
        half = numpy.full(15, 0.5 * flow.length)
        return (_field_at(flow, shots, half, exact.GHIA_Z * flow.length, "u") / lid - exact.GHIA_U[reynolds],
                _field_at(flow, shots, exact.GHIA_X * flow.length, half, "w") / lid - exact.GHIA_W[reynolds])

    settings = {"output.snapshot_interval": '"0.5 s"'}
    if reynolds == 100:
        # At this spacing the pressure of the corner where the lid runs against the wall compresses water of c0 = 10 U by 4 %.
        settings["numerics.sound_speed"] = "20"
    flow = study.run(check.name, case, {"numerics.spacing": '"10 mm"', **settings})
    u, w = measure(flow)
    both = numpy.concatenate([u, w])
    check.norm("largest error on both centre lines, 100 a side, over the lid's velocity", numpy.abs(both).max(), 0.03)
    check.norm("rms of the same", math.sqrt(numpy.mean(both**2)))
    check.best, check.cost = options_text(flow), flow.cost_text
    figure = figures.Figure(2)
    axes = figure.panel("velocity u / U on x = L/2", "height z / L")
    figures.exact(axes, exact.GHIA_U[reynolds], exact.GHIA_Z, "Ghia et al.", marker=".")
    figures.simulated(axes, u + exact.GHIA_U[reynolds], exact.GHIA_Z, "particles")
    axes = figure.panel("place x / L", "velocity w / U on z = L/2")
    figures.exact(axes, exact.GHIA_X, exact.GHIA_W[reynolds], "Ghia et al.", marker=".")
    figures.simulated(axes, exact.GHIA_X, w + exact.GHIA_W[reynolds], "particles")
    check.figures.append((figure.svg(check.name), "Velocities on the centre lines: the tables (lines between their points) and the particles, averaged over the last tenth of the run."))
    check.budgets_of(flow, energy=False)
    e = flow.series["kinetic_energy"]
    late = e[-max(len(e) // 10, 2):]
    check.budget("energy", f"{late[-1] / late[0] - 1:+.1e}", "change of the kinetic energy over the last tenth of the run (the work of the lid is not in the results)")
    if not study.quick:
        refinement(study, check, case, ("40 mm", "20 mm", "10 mm") if reynolds == 100 else ("20 mm", "10 mm"),
                   lambda f: math.sqrt(numpy.mean(numpy.concatenate(measure(f)) ** 2)), "rms error on the centre lines / U", settings)
        if reynolds == 100:
            compare_options(study, check, case, {
                "c0 = 10 U": {"numerics.sound_speed": "10"}, "h = 2 dx": {"numerics.smoothing_ratio": "2", "numerics.wall_layers": "4"},
                "c0 = 10 U, h = 2 dx": {"numerics.sound_speed": "10", "numerics.smoothing_ratio": "2", "numerics.wall_layers": "4"}},
                flow, lambda f: numpy.abs(numpy.concatenate(measure(f))).max(), "largest error on the centre lines / U",
                {"numerics.spacing": '"10 mm"', **settings})
    return check


def cavity_100(study):
    return cavity(study, 100)


def cavity_1000(study):
    return cavity(study, 1000)


CHECKS = {"poiseuille": poiseuille, "couette": couette, "laminar_re10": laminar_10, "laminar_re100": laminar_100,
          "laminar_re200": laminar_200, "laminar_water": film, "ramp": ramp, "taylor_green_re100": taylor_green_100,
          "taylor_green_re1000": taylor_green_1000, "cavity_re100": cavity_100, "cavity_re1000": cavity_1000}
