"""Rough beds with resolved eddies: flow condition 2 over the drag of the spheres and over the spheres themselves, conditions 5, 1 and 8."""

import h5py
import numpy

import figures
from check import Check
from options import options_text
from table import Table

KAPPA = 0.41
NEZU = {"u": 2.30, "v": 1.63, "w": 1.27}


class Measured:
    """A flow condition of the flume (thesis, Table 3.1), SI; `datum`: of the depth, above the bed level of the case."""

    def __init__(self, number, depth, velocity, friction_velocity, roughness, surface):
        self.number, self.depth, self.velocity, self.friction_velocity = number, depth, velocity, friction_velocity
        self.roughness, self.surface = roughness, surface

    def roughness_of_mean(self):
        """k_s that the rough log law has with the measured U and u*."""
        return self.depth * numpy.exp(-1 - KAPPA * (self.velocity / self.friction_velocity - 8.5))


CONDITION_1 = Measured(1, 40e-3, 0.28, 0.039, 35e-3, 0.32e-3)
CONDITION_2 = Measured(2, 50e-3, 0.35, 0.044, 35e-3, 0.40e-3)
CONDITION_5 = Measured(5, 70e-3, 0.36, 0.045, 30e-3, 1.15e-3)
CONDITION_8 = Measured(8, 100e-3, 0.43, 0.044, 22e-3, 1.50e-3)


class Bed:
    """Means over plan and time of a run between two times; heights in m above its bed level."""

    def __init__(self, study, name, title, case, settings, window, datum, crest, measured):
        self.run, self.window, self.datum, self.crest = study.run(name, case, settings), window, datum, crest
        self.title, self.measured = f"{title}, {window[0]:g} to {window[1]:g} s", measured
        self.findings = study.findings(self.run, "--window", f"{window[0]:g},{window[1]:g}")
        with h5py.File(self.run.folder / "results.h5") as file:
            blocks = file["profile_blocks"]
            time = blocks["time"][:]
            sums = blocks["sums"][:][(time > window[0]) & (time <= window[1] + 1e-6)].sum(axis=0)
            count = sums[:, 0]
            held = count > 0.02 * count.max()
            of = dict(zip(blocks.attrs["quantities"].decode().split(), (sums[held] / count[held, None]).T))
            self.summary = dict(file["summary"].attrs)  # of the case's own window
        series = self.run.series
        self.time, self.velocity, self.levels = series["time"], series["depth_mean_velocity"], series["mean_level"]
        self.level = self.levels[(self.time > window[0]) & (self.time <= window[1])].mean()
        self.z, self.u = of["height"], of["u"]
        self.rms = {axis: numpy.sqrt(of[2 * axis] - of[axis] ** 2) for axis in "uvw"}
        self.stress = of["u"] * of["w"] - of["uw"]
        self.friction_velocity = numpy.sqrt(self.run.gravity_x * (self.level - crest))  # of the weight above the crests

    def share(self):
        """Heights over the datum, over the depth."""
        return (self.z - self.datum) / (self.level - self.datum)

    def depth_mean_velocity(self):
        """Over the depth above the datum."""
        z = numpy.linspace(self.datum, self.level, 2001)
        return numpy.interp(z, self.z, self.u).mean()

    def stress_velocity(self):
        """u* of the line through the Reynolds stress, at the crests."""
        middle = (self.z > self.crest + 3e-3) & (self.z < self.level - 6e-3)
        return numpy.sqrt(numpy.polyval(numpy.polyfit(self.z[middle], self.stress[middle], 1), self.crest))

    def intensity_error(self, axis):
        """Rms of the departure from Nezu's law over the law, from 0.1 to 0.8 of the depth."""
        share = self.share()
        inside = (share > 0.1) & (share < 0.8)
        law = NEZU[axis] * numpy.exp(-share[inside])
        return numpy.sqrt(((self.rms[axis][inside] / self.friction_velocity / law - 1) ** 2).mean())

    def stress_error(self):
        """Rms of the departure of the Reynolds stress from the weight of the water above, over that at the crests, from the crests up."""
        above = self.z > self.crest
        line = (self.level - self.z[above]) / (self.level - self.crest)
        return numpy.sqrt(((self.stress[above] / self.friction_velocity**2 - line) ** 2).mean())

    def surface_velocity(self):
        """U of the uppermost row that is full."""
        return self.u[-1]

    def level_change(self, early, late):
        mean = lambda span: self.levels[(self.time >= span[0]) & (self.time <= span[1])].mean()
        return mean(late) / mean(early) - 1

    def force_balance(self):
        """Mean force on the bed over the weight component, with the change of the momentum between the first and the last second."""
        series, (start, end) = self.run.series, self.window
        inside = (self.time > start) & (self.time <= end)
        force = (series["drag_over_gravity"] + series["wall_over_gravity"])[inside].mean()
        mean = lambda low, high: series["total_mean_velocity"][(self.time > low) & (self.time <= high)].mean()
        return force + (mean(end - 1, end) - mean(start, start + 1)) / ((end - start - 1) * self.run.gravity_x)

    def late_level_change(self):
        return self.level_change((4, 8), (self.window[1] - 4, self.window[1]))


def _norms(check, bed):
    name, measured = bed.title, bed.measured
    check.norm(f"depth-mean velocity against the measured {measured.velocity:g} m/s; {name}", bed.depth_mean_velocity() / measured.velocity - 1, 0.06)
    check.norm(f"u* at the crests against the measured {measured.friction_velocity:g} m/s; {name}", bed.stress_velocity() / measured.friction_velocity - 1, 0.06)
    roughness = bed.findings["stress_equivalent_roughness"]
    check.norm(f"k_s with u* of the stress against the measured {1e3 * measured.roughness:g} mm; {name}", roughness / measured.roughness - 1, 0.25)
    check.norm(f"k_s with u* of the stress against that of the measured U and u*, {1e3 * measured.roughness_of_mean():.1f} mm; {name}",
               roughness / measured.roughness_of_mean() - 1, 0.25)
    for axis in "uvw":
        check.norm(f"{axis}' against Nezu's law, 0.1 to 0.8 of the depth, rms; {name}", bed.intensity_error(axis), 0.15)
    check.norm(f"-<u'w'> against the weight of the water above, over that at the crests, rms; {name}", bed.stress_error())
    check.norm(f"total stress against the line, over that at the crests, rms, in the case's own window; {name}", bed.summary["stress_error_rms"], 0.02)
    check.norm(f"standard deviation of the surface against the measured {1e3 * measured.surface:.2f} mm; {name}",
               bed.findings["plan_standard_deviation"] / measured.surface - 1, 0.3)
    for key, way in (("ridge", "by the ridge of the (k, omega) spectrum"), ("crests", "by crests that are followed")):
        if f"celerity_{key}" in bed.findings:
            check.norm(f"celerity of the surface's patterns over the velocity of the surface, less one, {way}; {name}",
                       bed.findings[f"celerity_{key}"] / bed.surface_velocity() - 1, 0.1)
    check.norm(f"what the scheme itself adds to the energy, of the input; {name}", bed.findings["energy_share_scheme"], 0.1)
    check.norm(f"force on the bed and change of the momentum against the weight; {name}", bed.force_balance() - 1, 0.01)
    check.norm(f"mean level, last 4 s against 4 to 8 s; {name}", bed.late_level_change(), 0.005)
    check.norm(f"independent samples of U in the window; {name}", bed.findings["effective_samples"], unit="")


def _table(check, beds):
    table = Table(check.title, ["quantity", *(bed.title for bed in beds), "reference"])
    row = lambda label, value, reference: table.rows.append([label, *(value(bed) for bed in beds), reference])
    measured = lambda text: "measured " + "; ".join(dict.fromkeys(text(bed.measured) for bed in beds))
    finding = lambda key, factor=1.0, digits=2: lambda bed: f"{factor * bed.findings[key]:.{digits}f}" if key in bed.findings else "-"
    row("U over the datum, m/s", lambda b: f"{b.depth_mean_velocity():.3f}", measured(lambda m: f"{m.velocity:g}"))
    row("u* at the crests, of the line through the Reynolds stress, m/s", lambda b: f"{b.stress_velocity():.4f}",
        measured(lambda m: f"{m.friction_velocity:g}") + " (of the whole depth)")
    row("k_s with u* of the stress, mm", lambda b: f"{1e3 * b.findings['stress_equivalent_roughness']:.1f}", measured(lambda m: f"{1e3 * m.roughness:g}"))
    row("k_s of the measured U and u* by the same law, mm", lambda b: f"{1e3 * b.measured.roughness_of_mean():.1f}", "")
    for axis in "uvw":
        row(f"{axis}'/u* at 0.2; 0.5; 0.8 of the depth",
            lambda b: "; ".join(f"{numpy.interp(x, b.share(), b.rms[axis] / b.friction_velocity):.2f}" for x in (0.2, 0.5, 0.8)),
            "Nezu " + "; ".join(f"{NEZU[axis] * numpy.exp(-x):.2f}" for x in (0.2, 0.5, 0.8)))
    row("share of noise in w'^2, 0.2 to 0.8 of the depth", finding("noise_share_of_vertical_velocity"), "0")
    row("share of the Reynolds stress that eddies carry, there", finding("eddies_share_of_stress"), "1")
    row("Reynolds number u* h/nu with the viscosity of water and noise", finding("reynolds_number_with_noise", digits=0), "")
    row("form drag of the solids, of their force", lambda b: f"{100 * b.findings['solid_form_drag_share'] / b.findings['solid_force_share']:.0f} %"
        if "solid_form_drag_share" in b.findings else "-", "")
    row("friction factor above the crests", finding("friction_factor_above_crests", digits=3), "")
    share = lambda key: lambda b: f"{100 * b.findings[f'friction_factor_{key}'] / b.findings['friction_factor_above_crests']:.1f} %"
    row("of it by Reynolds stress; by pair pressure, the scheme's own",
        lambda b: f"{100 * (b.findings['friction_factor_turbulent'] + b.findings.get('friction_factor_form_induced', 0)) / b.findings['friction_factor_above_crests']:.1f} %; "
        + share("pressure_of_pairs")(b), "100 % with viscosity and closure")
    row("standard deviation of the surface, mm", finding("plan_standard_deviation", 1e3), measured(lambda m: f"{1e3 * m.surface:.2f}"))
    for key, label in (("advected", "carried along by the water"), ("waves_downstream", "waves going downstream"), ("waves_upstream", "waves going upstream"),
                       ("waves_across", "waves going across"), ("bed_locked", "locked to the bed"), ("other", "none of these")):
        row(f"of its variance, {label}", finding(f"surface_share_{key}"), "")
    row("celerity of the ridge of the (k, omega) spectrum over U",
        lambda b: f"{b.findings['celerity_ridge'] / b.depth_mean_velocity():.2f}" if "celerity_ridge" in b.findings else "-", "1: advected with the flow")
    row("independent samples of U in the window", finding("effective_samples", digits=1), "10 for an interval")
    row("mean level, last 4 s against 4 to 8 s", lambda b: f"{100 * b.late_level_change():+.2f} %", "0")
    for part, label in (("density_diffusion", "density diffusion"), ("scheme", "what the scheme itself adds")):
        row(f"{label}, of the energy input", lambda b: f"{100 * b.findings[f'energy_share_{part}']:+.0f} %", "0")
    check.tables.append(table)


def resolved_bed(study):
    check = Check("resolved_bed", "Resolved eddies over a rough bed",
                  "Cells some three depths long and 1.7 wide: flow condition 2 over the drag of the spheres at their places, and over the spheres as solid bodies, "
                  "without a coefficient; flow condition 5 over the drag. Measured: depth-mean velocity, u*, k_s and the surface of the flume (thesis, Table 3.1); "
                  "intensities: Nezu's laws.")
    long = {"run.until": '"50 s"', "run.average_from": '"20 s"'}
    folder = "cases/rough-bed-3d/"
    beds = [Bed(study, "resolved_bed-drag", "condition 2, drag", folder + "resolved-eddies.toml", long, (20, 50), 6e-3, 10e-3, CONDITION_2),
            Bed(study, "resolved_bed-spheres", "condition 2, solid spheres", folder + "resolved-spheres.toml", {"run.until": '"62 s"', "run.average_from": '"20 s"'}, (20, 62), 8.5e-3, 12.5e-3,
                CONDITION_2),
            Bed(study, "resolved_bed-condition_5", "condition 5, drag", folder + "resolved-condition-5.toml", {}, (36, 70), 6e-3, 10e-3, CONDITION_5)]
    return _finished(check, beds, beds[1])


def resolved_depths(study):
    check = Check("resolved_depths", "Resolved eddies in shallow and in deep water",
                  "As the cells of conditions 2 and 5 over the drag of the spheres: conditions 1 and 8, 20 spacings deep.")
    folder = "cases/rough-bed-3d/"
    beds = [Bed(study, f"resolved_bed-condition_{measured.number}", f"condition {measured.number}, drag",
                f"{folder}resolved-condition-{measured.number}.toml", {}, window, 6e-3, 10e-3, measured)
            for measured, window in ((CONDITION_1, (20, 50)), (CONDITION_8, (20, 56)))]
    return _finished(check, beds, beds[1])


def _finished(check, beds, of_options):
    for bed in beds:
        _norms(check, bed)
    _table(check, beds)
    check.best, check.cost = options_text(of_options.run), "; ".join(f"{bed.title}: {bed.run.cost_text}" for bed in beds)
    check.figures.append((_figure(check.name, beds), "Mean velocity, intensities and Reynolds stress of the beds, and U over time."))
    return check


def _figure(name, beds):
    figure = figures.Figure(4, width=12.5, height=3.4)
    mean, turbulence, stress, course = (figure.panel(*labels) for labels in (
        ("U / measured depth mean", "height over the datum / depth"), ("intensity / u*", ""), ("-<u'w'> / u*²", ""), ("t, s", "U / measured")))
    share = numpy.linspace(0.1, 1, 50)
    for axis, style in zip("uw", ("-", "--")):
        figures.exact(turbulence, NEZU[axis] * numpy.exp(-share), share, f"Nezu {axis}'", linestyle=style)
    figures.exact(stress, [1, 0], [0.08, 1], "weight of the water above")
    for measured, style in zip(dict.fromkeys(bed.measured for bed in beds), ("-", "--")):
        law = measured.friction_velocity * (numpy.log(share * measured.depth / measured.roughness) / KAPPA + 8.5)
        figures.exact(mean, law / measured.velocity, share, f"log law of measured u*, k_s, condition {measured.number}", linestyle=style)
    figures.exact(course, [0, max(bed.time[-1] for bed in beds)], [1, 1], "measured")
    for colour, bed in zip(figures.COLOURS, beds):
        figures.simulated(mean, bed.u / bed.measured.velocity, bed.share(), None, colour)
        figures.simulated(turbulence, bed.rms["u"] / bed.friction_velocity, bed.share(), None, colour)
        turbulence.plot(bed.rms["w"] / bed.friction_velocity, bed.share(), "s", markersize=2.6, color=colour, fillstyle="none")
        figures.simulated(stress, bed.stress / bed.friction_velocity**2, bed.share(), None, colour)
        course.plot(bed.time, bed.velocity / bed.measured.velocity, color=colour, linewidth=0.9, label=bed.title.rsplit(",", 1)[0])
    turbulence.set_xlim(0, 2.6)
    return figure.svg(name)


CHECKS = {"resolved_bed": resolved_bed, "resolved_depths": resolved_depths}
