"""Turbulence that the particles resolve, against published solutions."""

import math

import numpy

import figures
from check import Check
from options import options_text
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


SHARES = {"scheme": "what the scheme itself adds", "pressure": "pressure of the scheme", "stepping": "time stepping, filters and spray",
          "density_diffusion": "density diffusion", "bed_drag": "drag of the bed", "closure": "closure", "viscosity": "molecular viscosity",
          "change": "rate of change of the energy"}


def _energy_shares(study, name, settings):
    """Run of the resolved channel, and the parts of its energy budget over the input, from `riffle analyse`."""
    run = study.run(name, "cases/rough-bed-3d/resolved-eddies.toml", {"run.until": '"8 s"', "run.average_from": '"3 s"', **settings})
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


CHECKS = {"taylor_green_space": taylor_green_space, "resolved_energy": resolved_energy}
