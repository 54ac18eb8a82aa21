"""Turbulence that the particles resolve, against published solutions."""

import math

import numpy

import figures
from check import Check
from options import options_text
from spectra import energy_spectrum, velocity_on_grid
from table import Table

# Rate at which the kinetic energy of the vortices falls at Re 1600, times 1000, u0^3/L: spectral method, 512^3 points (van Rees,
# Leonard, Pullin & Koumoutsakos 2011; the reference of case C3.5 of the workshops on high-order methods), at t = 0, 1 ... 10 L/u0.
SPECTRAL_DISSIPATION = numpy.array([0.47, 0.52, 0.71, 1.13, 2.07, 4.13, 5.53, 7.36, 10.37, 12.85, 11.27])
SPECTRAL_PEAK, SPECTRAL_PEAK_TIME = 12.86e-3, 8.97
SPECTRAL_ENERGY_AT_10 = 0.07448


class Vortices:
    """A run of the case: energies per mass over u0^2 and their rates over u0^3/L."""

    def __init__(self, run):
        self.run = run
        series = run.series
        self.time = series["time"]
        mass = 1.0 * (2 * math.pi) ** 3  # density 1, L = 1
        self.energy = series["kinetic_energy"] / mass
        self.parts = {name: series[f"{name}_power"] / mass for name in ("viscosity", "closure", "density_diffusion", "pressure")}
        elastic = series["elastic_energy"] / mass
        self.rest = numpy.gradient(self.energy + elastic, self.time) - sum(self.parts.values())
        # The rate over a quarter of the unit of time: sound makes the energy tremble.
        middle = numpy.arange(0.125, self.time[-1] - 0.125, 0.05)
        energy = lambda t: numpy.interp(t, self.time, self.energy)
        self.middle, self.dissipation = middle, (energy(middle - 0.125) - energy(middle + 0.125)) / 0.25

    def peak(self):
        index = self.dissipation.argmax()
        return self.dissipation[index], self.middle[index]

    def history_error(self):
        """Rms difference of the dissipation from the spectral one at t = 1, 2 ... 9, over the latter's peak."""
        times = numpy.arange(1, 10)
        found = numpy.interp(times, self.middle, self.dissipation)
        return math.sqrt(numpy.mean((found - 1e-3 * SPECTRAL_DISSIPATION[1:10]) ** 2)) / SPECTRAL_PEAK

    def means(self, first, last):
        """Mean rates of loss from `first` to `last`: by the parts, by what is left, and of the kinetic energy."""
        inside = (self.time >= first) & (self.time <= last)
        parts = {name: -power[inside].mean() for name, power in self.parts.items()}
        parts["rest"] = -self.rest[inside].mean()
        parts["kinetic"] = (numpy.interp(first, self.time, self.energy) - numpy.interp(last, self.time, self.energy)) / (last - first)
        return parts


def taylor_green_space(study):
    check = Check("taylor_green_space", "Taylor-Green vortices in space, Re 1600",
                  "Vortices that stretch each other, break up and decay as turbulence, without a closure; published: the dissipation "
                  "of a spectral solution with 512 points a side (van Rees et al. 2011).")
    sides = (32,) if study.quick else (48, 64, 96)
    found = {n: Vortices(study.run(f"taylor_green_space-{n}", "cases/turbulence/taylor-green-3d.toml",
                                   {"numerics.spacing": f'"{2 * math.pi / n:.9f} m"'})) for n in sides}
    for n, vortices in found.items():
        height, when = vortices.peak()
        if n < 64 and not study.quick:
            continue
        bar = {"bar": 0.1} if n >= 64 else {}  # fewer a side are stated alone
        check.norm(f"peak of the dissipation against the spectral one, {n} particles a side", height / SPECTRAL_PEAK - 1, **bar)
        check.norm(f"rms of the dissipation at t = 1 to 9 against the spectral one over its peak, {n} a side", vortices.history_error(), **bar)
        check.norm(f"time of the peak against the spectral one, {n} a side", when / SPECTRAL_PEAK_TIME - 1)
        check.norm(f"kinetic energy at t = 10 against the spectral one, {n} a side", vortices.energy[-1] / SPECTRAL_ENERGY_AT_10 - 1)
    finest = found[sides[-1]]
    check.best, check.cost = options_text(finest.run), "; ".join(f"{n} a side: {v.run.cost_text}" for n, v in found.items())
    figure = figures.Figure(1, width=5.2)
    axes = figure.panel("time t u0 / L", "dissipation, u0³/L / 1000")
    figures.exact(axes, numpy.arange(11), SPECTRAL_DISSIPATION, "spectral, 512 points a side", marker="o", markersize=3)
    for colour, (n, vortices) in zip(figures.COLOURS, found.items()):
        axes.plot(vortices.middle, 1000 * vortices.dissipation, color=colour, label=f"{n} particles a side")
    check.figures.append((figure.svg(check.name), "Rate at which the kinetic energy falls, over a quarter of the unit of time."))
    table = Table(f"{check.title}: what takes the energy, {sides[-1]} particles a side, u0³/L / 1000",
                  ["t", "kinetic energy falls by", "spectral", "viscosity", "density diffusion", "pressure of the scheme", "time stepping"])
    for first in range(0, 10, 2):
        m = finest.means(first, first + 2)
        spectral = numpy.interp([first + 0.5, first + 1.5], numpy.arange(11), SPECTRAL_DISSIPATION).mean()
        table.rows.append([f"{first} to {first + 2}", f"{1000 * m['kinetic']:.2f}", f"{spectral:.2f}"] +
                          [f"{1000 * m[name]:+.2f}" for name in ("viscosity", "density_diffusion", "pressure", "rest")])
    check.tables.append(table)
    return check


# Energy spectra behind a grid of M = 5.08 cm in air of U0 = 10 m/s: wave number, 1/cm; E at t U0 / M = 42, 98 and 171, cm3/s2
# (Comte-Bellot & Corrsin 1971, table 3). The runs start from the first.
GRID_TURBULENCE = numpy.array([
    (0.20, 129, 106, 92), (0.25, 230, 196, 120), (0.30, 322, 195, 125), (0.40, 435, 202, 98), (0.50, 457, 168, 81.5), (0.70, 380, 127, 60.2),
    (1.00, 270, 79.2, 39.4), (1.50, 168, 47.8, 24.1), (2.00, 120, 34.6, 16.5), (2.50, 89.0, 28.6, 12.5), (3.00, 70.3, 23.1, 9.12),
    (4.00, 47.0, 14.3, 5.62), (6.00, 24.7, 5.95, 1.69), (8.00, 12.6, 2.23, 0.520), (10.0, 7.42, 0.900, 0.161)]) * [100, 1e-6, 1e-6, 1e-6]
GRID_TIMES = {98: 0.28448, 171: 0.65532}  # t U0 / M: s after that at 42


class Decay:
    """A run of isotropic turbulence: E(k) at the times of the measurements over the measured one. What the fit of the velocity on a grid
    takes of small eddies is known from the start, whose spectrum is given."""

    def __init__(self, run, points):
        self.run, self.points, self.side = run, points, run.length
        series = run.series
        self.time, mass = series["time"], run.density * self.side**3
        self.energy = series["kinetic_energy"] / mass
        kept = None
        self.wavenumber, self.ratio, self.spectrum, self.compressive = None, {}, {}, {}
        for snapshot in run.snapshots():
            moment = next((m for m, t in {42: 0.0, **GRID_TIMES}.items() if abs(snapshot.time - t) < 0.003), None)
            if moment is None:
                continue
            places = numpy.stack([snapshot.x, snapshot.y, snapshot.z], axis=-1)
            velocity = numpy.stack([snapshot.u, snapshot.v, snapshot.w], axis=-1)
            k, spectrum, compressive = energy_spectrum(velocity_on_grid(places, velocity, self.side, points), self.side)
            inside = k >= GRID_TURBULENCE[0, 0]  # the measured spectra begin there
            k, spectrum, compressive = k[inside], spectrum[inside], compressive[inside]
            if moment == 42:
                kept = spectrum / measured_spectrum(k, 42)
                continue
            self.wavenumber, self.spectrum[moment] = k, spectrum / kept
            self.ratio[moment] = spectrum / kept / measured_spectrum(k, moment)
            self.compressive[moment] = compressive / spectrum

    def largest_wavenumber(self):
        """Of half a wave per spacing."""
        return math.pi * self.points / self.side

    def band(self, moment, low, high):
        """Geometric mean of the ratio over wave numbers from `low` to `high` of the largest."""
        share = self.wavenumber / self.largest_wavenumber()
        return math.exp(numpy.log(self.ratio[moment][(share > low) & (share <= high)]).mean())

    def energy_ratio(self, moment):
        """Kinetic energy of all particles over that of the measured spectrum up to the largest wave number, less one."""
        k = numpy.linspace(GRID_TURBULENCE[0, 0], self.largest_wavenumber(), 4001)
        measured = measured_spectrum(k, moment)
        held = ((measured[1:] + measured[:-1]) / 2 * numpy.diff(k)).sum()
        return numpy.interp(GRID_TIMES[moment], self.time, self.energy) / held - 1


def measured_spectrum(k, moment):
    column = {42: 1, 98: 2, 171: 3}[moment]
    return numpy.exp(numpy.interp(numpy.log(k), numpy.log(GRID_TURBULENCE[:, 0]), numpy.log(GRID_TURBULENCE[:, column])))


BANDS = [(0.0, 0.15), (0.15, 0.3), (0.3, 0.45), (0.45, 0.6), (0.6, 0.75), (0.75, 0.9)]


def isotropic_decay(study):
    check = Check("isotropic_decay", "Decay of isotropic turbulence",
                  "Eddies of a random field with the spectrum measured behind a grid at t U0 / M = 42, which break up and decay; measured: the "
                  "spectra at 98 and 171 (Comte-Bellot & Corrsin 1971).")
    sides = (32,) if study.quick else (48, 64)
    case, side = "cases/turbulence/isotropic-decay.toml", 0.5654866776
    spacing = lambda n: {"numerics.spacing": f'"{1000 * side / n:.9f} mm"'}
    found = {n: Decay(study.run(f"isotropic_decay-{n}", case, spacing(n)), n) for n in sides}
    finest = found[sides[-1]]
    for moment in GRID_TIMES:
        for low, high in ((0.0, 0.25), (0.25, 0.5)):
            share = f"{'below a quarter' if low == 0 else 'from a quarter to half'} of the largest wave number"
            bar = {} if study.quick else {"bar": 0.2}
            check.norm(f"E(k) against the measured one at t U0/M = {moment}, {share}, {sides[-1]} a side", finest.band(moment, low, high) - 1, **bar)
        check.norm(f"energy of the particles against the measured spectrum up to the largest wave number, t U0/M = {moment}", finest.energy_ratio(moment))
    table = Table(f"{check.title}: E(k) over the measured one, by wave numbers over the largest",
                  ["run", "t U0/M", "energy"] + [f"{low:g} to {high:g}" for low, high in BANDS] + ["compressive, above 0.6"])
    runs = {f"{n} a side": decay for n, decay in found.items()}
    if not study.quick:
        options = {"no closure": {"turbulence.closure": "none"}, "C_s = 0.2": {"turbulence.smagorinsky_constant": 0.2},
                   "density diffusion 0.1": {"numerics.density_diffusion_coefficient": 0.1},
                   "density diffusion 0.01": {"numerics.density_diffusion_coefficient": 0.01},
                   "c0 = 10 m/s": {"numerics.sound_speed": "10 m/s"}, "c0 = 40 m/s": {"numerics.sound_speed": "40 m/s"},
                   "T_B = 0.1 s": {"numerics.pressure_correction_time": "0.1 s"}, "h = 2 dx": {"numerics.smoothing_ratio": 2}}
        quoted = lambda value: f'"{value}"' if isinstance(value, str) else value
        for label, settings in options.items():
            name = "isotropic_decay-48-" + "_".join(label.replace("=", "").split())
            settings = spacing(48) | {key: quoted(value) for key, value in settings.items()}
            runs[f"48 a side, {label}"] = Decay(study.run(name, case, settings), 48)
    for label, decay in runs.items():
        for moment in GRID_TIMES:
            small = decay.wavenumber > 0.6 * decay.largest_wavenumber()
            table.rows.append([label, str(moment), f"{1 + decay.energy_ratio(moment):.2f}"] + [f"{decay.band(moment, *band):.2f}" for band in BANDS] +
                              [f"{decay.compressive[moment][small].mean():.2f}"])
    check.tables.append(table)
    check.best, check.cost = options_text(finest.run), "; ".join(f"{n} a side: {d.run.cost_text}" for n, d in found.items())
    figure = figures.Figure(1, width=5.2)
    axes = figure.panel("wave number k, 1/m", "E(k), m³/s²")
    axes.set_xscale("log")
    axes.set_yscale("log")
    within = GRID_TURBULENCE[:, 0] <= 1.05 * finest.largest_wavenumber()
    for column, (moment, marker) in enumerate(((42, "s"), (98, "o"), (171, "^")), 1):
        figures.exact(axes, GRID_TURBULENCE[within, 0], GRID_TURBULENCE[within, column], f"measured, t U0/M = {moment}", marker=marker, markersize=3, linestyle="none")
    # The last shell is cut by the largest wave number.
    whole = finest.wavenumber < 0.97 * finest.largest_wavenumber()
    for colour, moment in zip(figures.COLOURS, GRID_TIMES):
        axes.plot(finest.wavenumber[whole], finest.spectrum[moment][whole], color=colour, label=f"{sides[-1]} a side, t U0/M = {moment}")
    check.figures.append((figure.svg(check.name), "Energy spectra: measured behind the grid, and of the particles."))
    return check


SHARES = {"scheme": "what the scheme itself adds", "pressure": "pressure of the scheme", "stepping": "time stepping, filters and spray",
          "density_diffusion": "density diffusion", "bed_drag": "drag of the bed", "closure": "closure", "viscosity": "molecular viscosity",
          "change": "rate of change of the energy"}


def _energy_shares(study, name, settings):
    """Run of the resolved channel, and the parts of its energy budget over the input, from `riffle analyse`."""
    run = study.run(name, "cases/rough-bed-3d/resolved-eddies.toml", {"numerics.spacing": '"3 mm"', "run.until": '"8 s"', "run.average_from": '"3 s"', **settings})
    findings = study.findings(run)
    return run, {part: findings[f"energy_share_{part}"] for part in SHARES}


def resolved_energy(study):
    check = Check("resolved_energy", "Resolved eddies over spheres: energy budget",
                  "Shares of the weight's power from 3 to 8 s (`riffle analyse`, chapter energy): in the exact equations pressure gives nothing, and "
                  "what compression stores comes back. What the scheme itself adds or takes is held below a tenth.")
    run, shares = _energy_shares(study, "resolved_energy", {})
    check.norm("what the scheme itself adds, of the energy input", shares["scheme"], 0.1)
    # What it was with the whole pressure in the pairs, and the correction of each moment.
    _, whole = _energy_shares(study, "resolved_energy-pairs", {"numerics.reference_pressure": "none", "numerics.pressure_correction_time": '"0 s"'})
    table = Table(f"{check.title}, shares of the input, %", ["part", "as the case", "whole pressure in the pairs, correction of each moment"])
    table.rows = [[label, f"{100 * shares[part]:+.1f}", f"{100 * whole[part]:+.1f}"] for part, label in SHARES.items()]
    check.tables.append(table)
    check.best, check.cost = options_text(run), run.cost_text
    return check


CHECKS = {"taylor_green_space": taylor_green_space, "isotropic_decay": isotropic_decay, "resolved_energy": resolved_energy}
