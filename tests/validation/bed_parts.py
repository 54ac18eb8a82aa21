"""Beds by roughness and smooth beds against the log laws, and the mixing lengths with the local depth."""

import math

from bars import BARS, condition_case
from parts import MINUTE, bar_header, row_against_bars
from table import Table

GRAVEL = "cases/plane-beds/roughness.toml"
SMOOTH = "cases/plane-beds/smooth.toml"
MANNING = "cases/plane-beds/manning.toml"
KAPPA = 0.41
GRAVITY = 9.81
VISCOSITY = 1e-6


def log_law_mean(depth, zero_height):
    """Depth mean of ln((z + z0)/z0)/kappa."""
    ratio = depth / zero_height
    return ((1 + 1 / ratio) * math.log1p(ratio) - 1) / KAPPA


def rough_zero_height(roughness):
    return roughness * math.exp(-8.5 * KAPPA)


def smooth_zero_height(friction_velocity):
    return VISCOSITY / friction_velocity * math.exp(-5.29 * KAPPA)


def settings_of(depth, rows, seconds, more=None):
    spacing = depth / rows
    return {"numerics.spacing": f'"{1000 * spacing:.6g} mm"', "channel.length": f'"{1000 * 20 * spacing:.6g} mm"',
            "run.until": f'"{seconds:g} s"', "run.average_from": f"{0.75 * seconds:g}", **(more or {})}


def bed_row(table, run, name, label, case, settings, depth, slope, zero_height, bar):
    result = run(name, case, settings)
    friction_velocity = math.sqrt(GRAVITY * math.sin(math.atan(slope)) * depth)
    law = friction_velocity * log_law_mean(depth, zero_height)
    v = result.values
    error = v["depth_mean_velocity"] / law - 1
    twin = v["depth_mean_velocity"] / result.column["depth_mean_velocity"] - 1
    table.rows.append([label, f"{law:.4f}", f"{result.column['depth_mean_velocity']:.4f}", f"{v['depth_mean_velocity']:.4f}",
                       table.check(label, "U against the log law", error, bar, f"{100 * error:+.2f}"), f"{100 * twin:+.2f}",
                       f"{100 * v['force_balance_error']:+.2f}",
                       f"{100 * v['level_drift_share']:+.2f}"])


def bed_header(bar):
    return ["case", "U of the log law, m/s", "U of the twin", "U of the particles", f"against the log law, % (<= {bar:g})", "against the twin, %",
            "friction/weight - 1, %", "depth since the start, %"]


def beds(run):
    table = Table("Beds by their roughness, depth 0.5 m, slope 0.001, closure nezu-rodi: depth-mean velocity against the log law", bed_header(1))
    depth, slope = 0.5, 0.001
    friction_velocity = math.sqrt(GRAVITY * slope * depth)
    for share in (0.002, 0.01, 0.05, 0.3):
        roughness = share * depth
        zero = rough_zero_height(roughness) + smooth_zero_height(friction_velocity)
        for rows in (12, 20, 36):
            settings = settings_of(depth, rows, 120, {"bed.equivalent_roughness": f'"{1000 * roughness:.6g} mm"'})
            bed_row(table, run, f"bed-{share}-{rows}", f"k_s/h = {share:g}, {rows} rows", GRAVEL, settings, depth, slope, zero, 0.01)
    return table


def smooth_beds(run):
    table = Table("Smooth beds, closure nezu-rodi: depth-mean velocity against the smooth log law of Nezu & Rodi (1986)", bed_header(3))
    for depth, slope, seconds in ((0.05, 0.001, 80), (0.5, 0.001, 150)):
        friction_velocity = math.sqrt(GRAVITY * math.sin(math.atan(slope)) * depth)
        for rows in (12, 20, 36) if depth < 0.1 else (20,):
            more = {"channel.depth": f'"{depth:g} m"', "channel.slope": f"{slope:g}"}
            label = f"u_* h/nu = {friction_velocity * depth / VISCOSITY:.0f}, {rows} rows"
            bed_row(table, run, f"smooth-{depth}-{rows}", label, SMOOTH, settings_of(depth, rows, seconds, more), depth, slope,
                    smooth_zero_height(friction_velocity), 0.03)
    return table


def bed_closures(run):
    """Closures whose profile is not the log law, Manning's n, wider kernels: against the column twin of the same."""
    table = Table("Other closures and choices over plane beds, 20 rows: against the column twin of the same closure",
                  ["case", "U of the twin", "U of the particles", "%", "n of the particles, s/m^(1/3)"])
    depth = 0.5
    for label, name, case, at, more in (
            ("k_s/h = 0.05, ramp", "ramp", GRAVEL, depth, {"turbulence.closure": "ramp"}),
            ("k_s/h = 0.05, nikuradse", "nikuradse", GRAVEL, depth, {"turbulence.closure": "nikuradse"}),
            ("k_s/h = 0.05, nezu-rodi, wake 0.2", "wake", GRAVEL, depth, {"turbulence.wake_strength": "0.2"}),
            ("k_s/h = 0.05, h = 1.5 dx", "narrow", GRAVEL, depth, {"numerics.smoothing_ratio": "1.5"}),
            ("n = 0.025, ramp, 1 m", "manning", MANNING, 1.0, {})):
        result = run(f"closure-{name}", case, settings_of(at, 20, 120 if at < 1 else 240, more))
        v, twin = result.values, result.column["depth_mean_velocity"]
        error = v["depth_mean_velocity"] / twin - 1
        slope = 0.001 if at < 1 else 0.0005
        n = at ** (2 / 3) * math.sqrt(slope) / v["depth_mean_velocity"]
        table.rows.append([label, f"{twin:.4f}", f"{v['depth_mean_velocity']:.4f}",
                           table.check(label, "U against the twin", error, 0.01, f"{100 * error:+.2f}"), f"{n:.4f}"])
    return table


def beds_in_space(run):
    table = Table("Beds by their roughness in three dimensions, a cell seven spacings wide and long, depth 0.5 m, slope 0.001, closure nezu-rodi", bed_header(1))
    depth, slope = 0.5, 0.001
    friction_velocity = math.sqrt(GRAVITY * slope * depth)
    for share, rows in ((0.01, 12), (0.3, 12), (0.05, 20)):
        roughness = share * depth
        zero = rough_zero_height(roughness) + smooth_zero_height(friction_velocity)
        side = f'"{7000 * depth / rows:.6g} mm"'
        more = {"bed.equivalent_roughness": f'"{1000 * roughness:.6g} mm"', "channel.dimensions": "3", "channel.width": side}
        settings = {**settings_of(depth, rows, 120, more), "channel.length": side}
        bed_row(table, run, f"space-{share}-{rows}", f"k_s/h = {share:g}, {rows} rows", GRAVEL, settings, depth, slope, zero, 0.01)
    return table


def local_depth(run):
    """The local depth in uniform flow holds the bars of the initial one, and deeper water has the flow of its depth."""
    table = Table("The depth of the mixing lengths, condition 2, 20 to 60 s", bar_header(BARS))
    row_against_bars(table, "turbulence.depth = \"local\"", run("condition-2-local", condition_case(2), dict(MINUTE, **{"turbulence.depth": '"local"'})), BARS)
    return table


BED_PARTS = {"beds": beds, "smooth_beds": smooth_beds, "bed_closures": bed_closures, "beds_in_space": beds_in_space, "local_depth": local_depth}
BEDS = ["beds", "smooth_beds", "bed_closures", "beds_in_space", "local_depth"]
