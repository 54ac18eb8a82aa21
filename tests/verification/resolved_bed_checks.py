"""Flow condition 2 with resolved eddies: over the drag of the spheres, and over the spheres themselves."""

import h5py
import numpy

import figures
from check import Check
from options import options_text
from table import Table

KAPPA = 0.41
MEASURED = {"velocity": 0.35, "friction_velocity": 0.044, "roughness": 35e-3, "surface": 0.40e-3}  # thesis, Table 3.1
NEZU = {"u": 2.30, "v": 1.63, "w": 1.27}


class Bed:
    """Means over plan and time of a run between two times; heights in m above its bed level."""

    def __init__(self, study, name, case, settings, window, datum, crest):
        self.run, self.window, self.datum, self.crest = study.run(name, case, settings), window, datum, crest
        self.findings = study.findings(self.run, "--window", f"{window[0]:g},{window[1]:g}")
        with h5py.File(self.run.folder / "results.h5") as file:
            blocks = file["profile_blocks"]
            time = blocks["time"][:]
            sums = blocks["sums"][:][(time > window[0]) & (time <= window[1] + 1e-6)].sum(axis=0)
            count = sums[:, 0]
            held = count > 0.02 * count.max()
            of = dict(zip(blocks.attrs["quantities"].decode().split(), (sums[held] / count[held, None]).T))
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

    def roughness(self):
        """k_s of the log law with that u*, from 2 mm above the crests to half of the depth, over the datum."""
        low = (self.z > self.crest + 2e-3) & (self.share() < 0.5)
        logarithm = numpy.log(self.z[low] - self.datum) - KAPPA * self.u[low] / self.friction_velocity
        return 30 * numpy.exp(logarithm.mean())

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

    def level_change(self, early, late):
        mean = lambda span: self.levels[(self.time >= span[0]) & (self.time <= span[1])].mean()
        return mean(late) / mean(early) - 1


def resolved_bed(study):
    check = Check("resolved_bed", "Resolved eddies over a rough bed: flow condition 2",
                  "A cell three depths long and 1.7 wide, over the drag of the spheres at their places, and over the spheres as solid bodies, without "
                  "a coefficient. Measured: depth-mean velocity, u*, k_s and the surface of the flume (thesis, Table 3.1); intensities: Nezu's laws.")
    long = {"run.until": '"62 s"', "run.average_from": '"20 s"', "output.snapshot_interval": '"5 s"', "output.mean_field_interval": '"20 s"'}
    beds = {"drag": Bed(study, "resolved_bed-drag", "cases/rough-bed-3d/resolved-eddies.toml", long, (20, 62), 6e-3, 10e-3),
            "spheres": Bed(study, "resolved_bed-spheres", "cases/rough-bed-3d/resolved-spheres.toml", {"run.until": '"34 s"'}, (16, 34), 8.5e-3, 12.5e-3)}
    names = {"drag": "drag of the spheres, 20 to 62 s", "spheres": "solid spheres, 16 to 34 s"}
    table = Table(check.title, ["quantity", *names.values(), "reference"])
    row = lambda label, value, reference: table.rows.append([label, *[value(bed) for bed in beds.values()], reference])
    for key, bed in beds.items():
        name = names[key]
        check.norm(f"depth-mean velocity against the measured 0.35 m/s; {name}", bed.depth_mean_velocity() / MEASURED["velocity"] - 1, 0.06)
        check.norm(f"u* at the crests against the measured 0.044 m/s; {name}", bed.stress_velocity() / MEASURED["friction_velocity"] - 1, 0.06)
        check.norm(f"k_s against the measured 35 mm; {name}", bed.roughness() / MEASURED["roughness"] - 1, 0.25)
        for axis in "uvw":
            check.norm(f"{axis}' against Nezu's law, 0.1 to 0.8 of the depth, rms; {name}", bed.intensity_error(axis), 0.15)
        check.norm(f"-<u'w'> against the weight of the water above, over that at the crests, rms; {name}", bed.stress_error())
        check.norm(f"standard deviation of the surface against the measured 0.40 mm; {name}", bed.findings["plan_standard_deviation"] / MEASURED["surface"] - 1, 0.3)
        late = (bed.window[1] - 4, bed.window[1])
        check.norm(f"mean level, last 4 s against 4 to 8 s; {name}", bed.level_change((4, 8), late), 0.005)
        check.norm(f"independent samples of U in the window; {name}", bed.findings["effective_samples"], unit="")
    row("U over the datum, m/s", lambda b: f"{b.depth_mean_velocity():.3f}", "measured 0.35")
    row("u* at the crests, of the line through the Reynolds stress, m/s", lambda b: f"{b.stress_velocity():.4f}", "measured 0.044 (of the whole depth)")
    row("k_s, u* of the weight above the crests, mm", lambda b: f"{1e3 * b.roughness():.1f}", "measured 35")
    for axis in "uvw":
        row(f"{axis}'/u* at 0.2; 0.5; 0.8 of the depth",
            lambda b: "; ".join(f"{numpy.interp(x, b.share(), b.rms[axis] / b.friction_velocity):.2f}" for x in (0.2, 0.5, 0.8)),
            "Nezu " + "; ".join(f"{NEZU[axis] * numpy.exp(-x):.2f}" for x in (0.2, 0.5, 0.8)))
    row("share of noise in w'^2, 0.2 to 0.8 of the depth", lambda b: f"{b.findings['noise_share_of_vertical_velocity']:.2f}", "0")
    row("share of the Reynolds stress that eddies carry, there", lambda b: f"{b.findings['eddies_share_of_stress']:.2f}", "1")
    row("standard deviation of the surface, mm", lambda b: f"{1e3 * b.findings['plan_standard_deviation']:.2f}", "measured 0.40; thesis, simulated 0.07 to 0.14")
    row("celerity of the ridge of the (k, omega) spectrum over U", lambda b: f"{b.findings['celerity_ridge'] / b.depth_mean_velocity():.2f}", "1: advected with the flow")
    row("independent samples of U in the window", lambda b: f"{b.findings['effective_samples']:.1f}", "10 for an interval")
    row("mean level, last 4 s against 4 to 8 s", lambda b: f"{100 * b.level_change((4, 8), (b.window[1] - 4, b.window[1])):+.2f} %", "0")
    for part, label in (("density_diffusion", "density diffusion"), ("scheme", "what the scheme itself adds")):
        row(f"{label}, of the energy input", lambda b: f"{100 * b.findings[f'energy_share_{part}']:+.0f} %", "0")
    check.tables.append(table)
    check.best, check.cost = options_text(beds["spheres"].run), "; ".join(f"{names[key]}: {bed.run.cost_text}" for key, bed in beds.items())
    check.figures.append((_figure(check.name, beds, names), "Mean velocity, intensities and Reynolds stress of both beds, and U over time."))
    return check


def _figure(name, beds, names):
    figure = figures.Figure(4, width=12.5, height=3.4)
    mean, turbulence, stress, course = (figure.panel(*labels) for labels in (
        ("U, m/s", "height over the datum / depth"), ("intensity / u*", ""), ("-<u'w'> / u*²", ""), ("t, s", "U, m/s")))
    share = numpy.linspace(0.1, 1, 50)
    for axis, style in zip("uw", ("-", "--")):
        figures.exact(turbulence, NEZU[axis] * numpy.exp(-share), share, f"Nezu {axis}'", linestyle=style)
    figures.exact(stress, [1, 0], [0.08, 1], "weight of the water above")
    depth = 50e-3
    law = MEASURED["friction_velocity"] / KAPPA * numpy.log(30 * share * depth / MEASURED["roughness"])
    figures.exact(mean, law, share, "log law of the measured u*, k_s")
    figures.exact(course, [0, 62], [MEASURED["velocity"]] * 2, "measured")
    for colour, (key, bed) in zip(figures.COLOURS, beds.items()):
        figures.simulated(mean, bed.u, bed.share(), None, colour)
        figures.simulated(turbulence, bed.rms["u"] / bed.friction_velocity, bed.share(), None, colour)
        turbulence.plot(bed.rms["w"] / bed.friction_velocity, bed.share(), "s", markersize=2.6, color=colour, fillstyle="none")
        figures.simulated(stress, bed.stress / bed.friction_velocity**2, bed.share(), None, colour)
        course.plot(bed.time, bed.velocity, color=colour, linewidth=0.9, label=names[key].split(",")[0])
    turbulence.set_xlim(0, 2.6)
    return figure.svg(name)


CHECKS = {"resolved_bed": resolved_bed}
