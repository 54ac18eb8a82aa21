"""Bars of the 2D channel and the runs that are held against them."""

# Flow over spheres with the default numerics.
# name in /summary (absolute value), bar, printed label, unit factor, format
BARS = [
    ("velocity_error_above_rms", 0.01, "U above crest, rms %", 100.0),
    ("velocity_error_above_maximum", 0.02, "U above crest, max %", 100.0),
    ("velocity_error_below_rms", 0.025, "U below crest, rms %", 100.0),
    ("velocity_error_below_maximum", 0.04, "U below crest, max %", 100.0),
    ("total_mean_velocity_error", 0.01, "mean U %", 100.0),
    ("spurious_stress_rms", 0.005, "spurious stress %", 100.0),
    ("stress_error_rms", 0.015, "total stress %", 100.0),
    ("force_balance_error", 0.01, "drag+wall/gravity - 1, %", 100.0),
    ("level_drift_share", 0.005, "depth drift, % of H", 100.0),
]

# Under stirring the disorder is the test: these bars replace or add to the layered ones.
STIRRED_BARS = [
    ("spurious_stress_rms", 0.015, "spurious stress %", 100.0),
    ("force_balance_error", 0.01, "drag+wall/gravity - 1, %", 100.0),
    ("level_drift_10_s", 1.0e-4, "depth drift in 10 s, mm", 1000.0),
]

UNIFORM_CONDITIONS = [1, 2, 3, 5, 6, 7, 8]


def condition_case(number):
    return f"cases/rough-bed-2d/condition-{number}.toml"


PAPER_CASE = "cases/paper-2016.toml"

STIRRING = {"stirring.acceleration": "0.3", "numerics.spacing": '"2 mm"', "run.until": '"26 s"', "run.average_from": "16"}
