"""Every choice of the method in one flow: what the advice of the documents rests on."""

import concurrent.futures
import os

from bars import STIRRING, condition_case
from table import Table

# A reach of 80 mm at 2 mm: seconds a run. Quiet: the lasting flow; stirred: a force that disorders the particles.
SHORT = {"channel.length": '"80 mm"', "numerics.spacing": '"2 mm"'}
QUIET = {"run.until": '"24 s"', "run.average_from": "12"}
NARROW = {"numerics.smoothing_ratio": "1.5", "numerics.wall_layers": "3"}

CHOICES = [
    ("the defaults", {}),
    ("kernel cubic-spline", {"numerics.kernel": "cubic-spline"}),
    ("kernel gaussian", {"numerics.kernel": "gaussian"}),
    ("kernel quadratic", {"numerics.kernel": "quadratic"}),
    ("kernel quintic-spline", {"numerics.kernel": "quintic-spline"}),
    ("kernel wendland-c4", {"numerics.kernel": "wendland-c4"}),
    ("kernel wendland-c6", {"numerics.kernel": "wendland-c6"}),
    ("h = 1.5 dx", NARROW),
    ("h = 1.5 dx, density diffusion 0.02", dict(NARROW, **{"numerics.density_diffusion_coefficient": "0.02"})),
    ("h = 1.75 dx", {"numerics.smoothing_ratio": "1.75", "numerics.wall_layers": "4"}),
    ("h = 2.5 dx", {"numerics.smoothing_ratio": "2.5", "numerics.wall_layers": "5"}),
    ("hexagonal lattice", {"start.lattice": "hexagonal"}),
    ("pressure_form symmetric", {"numerics.pressure_form": "symmetric"}),
    ("pressure_form symmetric, h = 1.5 dx", dict(NARROW, **{"numerics.pressure_form": "symmetric"})),
    ("pressure_form symmetric, kernel wendland-c4", {"numerics.pressure_form": "symmetric", "numerics.kernel": "wendland-c4"}),
    ("pressure_form symmetric, kernel wendland-c6", {"numerics.pressure_form": "symmetric", "numerics.kernel": "wendland-c6"}),
    ("pressure_form symmetric, kernel cubic-spline, h = 1.5 dx", dict(NARROW, **{"numerics.pressure_form": "symmetric", "numerics.kernel": "cubic-spline"})),
    ("pressure_form riemann", {"numerics.pressure_form": "riemann"}),
    ("reference_pressure hydrostatic", {"numerics.reference_pressure": "hydrostatic"}),
    ("reference_pressure hydrostatic, h = 1.5 dx", dict(NARROW, **{"numerics.reference_pressure": "hydrostatic"})),
    ("velocity_gradient plain", {"numerics.velocity_gradient": "plain"}),
    ("kernel_correction kernel", {"numerics.kernel_correction": "kernel"}),
    ("density_diffusion none", {"numerics.density_diffusion": "none"}),
    ("density_diffusion molteni", {"numerics.density_diffusion": "molteni"}),
    ("density_diffusion antuono", {"numerics.density_diffusion": "antuono"}),
    ("viscosity monaghan-gingold", {"numerics.viscosity": "monaghan-gingold"}),
    ("viscosity lo-shao", {"numerics.viscosity": "lo-shao"}),
    ("eddy_stress stress-divergence", {"numerics.eddy_stress": "stress-divergence"}),
    ("equation_of_state tait", {"numerics.equation_of_state": "tait"}),
    ("c0 = 10 U_max", {"numerics.sound_speed": "4.53"}),
    ("c0 = 40 U_max", {"numerics.sound_speed": "18.1"}),
    ("wall modified-dynamic", {"numerics.wall": "modified-dynamic"}),
    ("xsph 0.1", {"numerics.xsph": "0.1", "numerics.stepping": "semi-implicit-euler"}),
    ("Courant number 0.35", {"numerics.courant_number": "0.35"}),
    ("stepping semi-implicit-euler", {"numerics.stepping": "semi-implicit-euler"}),
    ("stepping predictor-corrector", {"numerics.stepping": "predictor-corrector", "numerics.courant_number": "0.4"}),
    ("drag_sampling point", {"numerics.drag_sampling": "point"}),
    ("preset thesis", {"numerics.preset": "thesis", "numerics.spacing": '"2 mm"', "numerics.sound_speed": "9"}),
]


def columns(result):
    if result is None:
        return ["fails"] * 5
    v = result.values
    share = v["velocity_fluctuation"] / result.column["friction_velocity"]
    return [f"{100 * v['total_mean_velocity_error']:+.2f}", f"{100 * v['velocity_error_above_rms']:.2f}", f"{100 * v['spurious_stress_rms']:.2f}",
            f"{share:.2f}", f"{v['particle_order']:.2f}"]


def choices(run):
    """Shown, not held: these choices promise nothing."""
    heads = ["mean U %", "U above crest, rms %", "spurious stress %", "velocity fluctuation / u_*", "particle order"]
    table = Table("Each choice of the method in condition 2 (dx 2 mm, a reach of 80 mm): the lasting flow (12 to 24 s), and stirred (F = 0.3 m/s2, 16 to 26 s)",
                  ["choice"] + heads + [f"stirred: {head}" for head in heads])

    def attempt(job):
        number, flow, settings = job
        try:
            return run(f"choice-{number}-{flow}", condition_case(2), dict(SHORT | (STIRRING if flow == "stirred" else QUIET), **settings))
        except SystemExit as failure:
            print(str(failure).splitlines()[-1])
            return None

    def own(settings):
        return {key: value for key, value in settings.items() if key not in SHORT}

    jobs = [(number, flow, own(settings)) for number, (_, settings) in enumerate(CHOICES) for flow in ("quiet", "stirred")]
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        results = list(pool.map(attempt, jobs))
    for (name, _), quiet, stirred in zip(CHOICES, results[::2], results[1::2]):
        table.rows.append([name] + columns(quiet) + columns(stirred))
    return table


CHOICE_PARTS = {"choices": choices}
