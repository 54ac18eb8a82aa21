"""The parts of the validation in three dimensions."""

import json
import math
import subprocess

import h5py
import numpy

from parts import bar_header, row_against_bars
from runs import ROOT, half_width
from table import Table

# name in RiffleRun.values (absolute value), bar, printed label, unit factor
COMMON_BARS = [
    ("spurious_stress_rms", 0.01, "spurious stress %", 100.0),
    ("stress_error_rms", 0.035, "total stress %", 100.0),
    ("force_balance_error", 0.01, "drag+walls/gravity - 1, %", 100.0),
    ("budget_error", 0.001, "momentum budget, %", 100.0),
    ("pressure_error", 0.05, "pressure below 0.9 H, max %", 100.0),
]


def space_bars(mean_velocity):
    """Bars of a run against its twin; that of the depth-mean velocity depends on drag form and start."""
    return [
        ("total_mean_velocity_error", mean_velocity, "mean U %", 100.0),
        ("velocity_error_above_rms", 0.02, "U above crest, rms %", 100.0),
        ("velocity_error_above_maximum", 0.04, "U above crest, max %", 100.0),
        ("velocity_error_below_rms", 0.10, "U below crest, rms %", 100.0),
        ("velocity_error_below_maximum", 0.15, "U below crest, max %", 100.0),
    ] + COMMON_BARS


CONDITIONS = [1, 2, 5, 8]
MEASURED = {1: (0.040, 0.28), 2: (0.050, 0.35), 5: (0.070, 0.36), 8: (0.100, 0.43)}  # thesis Table 3.1: h_w, U
STIRRING = {"stirring.acceleration": "0.3", "run.until": '"26 s"', "run.average_from": "16"}


def case_file(number, family):
    return f"cases/rough-bed-3d/condition-{number}{family}.toml"


def complete(result):
    """Adds what the bars of three dimensions need to the values of a run."""
    v, series = result.values, result.series
    side = series["side_wall_over_gravity"]
    v["force_balance_error"] = v["drag_over_gravity"] + v["wall_over_gravity"] + v["side_wall_over_gravity"] - 1.0
    # Change of the momentum over the window against the forces recorded on the way.
    inside = (series["time"] >= v["window_start"]) & (series["time"] <= v["window_end"])
    time = series["time"][inside]
    excess = 1.0 - (series["drag_over_gravity"] + series["wall_over_gravity"] + side)[inside]
    with h5py.File(result.folder / "results.h5", "r") as file:
        case = {line.split(" = ")[0]: line.split(" = ")[1] for line in file["/case/text"][()].decode().split("\n") if " = " in line}
    slope, gravity = float(case["slope"]), float(case["gravity"])
    weight = gravity * math.sin(math.atan(slope))
    gained = (series["total_mean_velocity"][inside][-1] - series["total_mean_velocity"][inside][0]) / (time[-1] - time[0])
    v["budget_error"] = gained / weight - numpy.trapz(excess, time) / (time[-1] - time[0])
    z, pressure = result.profiles["z"], result.profiles["pressure"]
    depth = v["total_depth"]
    hydrostatic = 1000.0 * gravity * math.cos(math.atan(slope)) * (depth - z)
    low = z < 0.9 * depth
    v["pressure_error"] = numpy.max(numpy.abs(pressure[low] / hydrostatic[low] - 1.0))
    return result


# Where the means are taken: after three relaxation times, which grow with the depth.
WINDOW = {number: {"run.until": f'"{until} s"', "run.average_from": str(begin)} for number, (until, begin) in {1: (24, 12), 2: (24, 14), 5: (30, 20), 8: (46, 34)}.items()}


PLAN_MEAN = {"bed.drag_form": "plan-mean"}
WIDE_EXTRA = ["depth-mean U, m/s", "velocity fluctuation / u_*"]


def wide_row(table, run, name, label, number, settings, bars):
    result = complete(run(name, case_file(number, "-wide"), dict(WINDOW[number], **settings)))
    row_against_bars(table, label, result, bars)
    v = result.values
    table.rows[-1] += [f"{v['depth_mean_velocity']:.4f}", f"{v['velocity_fluctuation'] / result.column['friction_velocity']:.2f}"]


def space_twin(run):
    """The plan mean of the drag in the particles: exactly the model of the column twin."""
    bars = space_bars(0.02)
    table = Table("Cell of 50 by 43.3 mm, periodic across, drag by its plan mean: against the column twin of the same model",
                  bar_header(bars) + WIDE_EXTRA)
    for spacing in ("4mm", "3mm", "2.5mm"):
        wide_row(table, run, f"twin-2-{spacing}", f"condition 2, dx {spacing}", 2, dict(PLAN_MEAN, **{"numerics.spacing": spacing}), bars)
    wide_row(table, run, "twin-2-stirred", "condition 2, dx 3mm, stirred", 2, dict(PLAN_MEAN, **STIRRING), space_bars(0.03))
    return table


def space_side_quick(run):
    """The layer beside a side wall, in continuous integration."""
    table = Table("Half of a channel 86.6 mm wide with its side wall, 50 mm long, dx 4 mm, 7 s: against the cross-section twin",
                  ["case", "U(y) beside the wall, max % (<= 10)", "drag+walls/gravity - 1, % (<= 1)"])
    result = complete(run("quick-2-side", case_file(2, "-coarse"),
                          {"channel.width": '"86.6 mm"', "numerics.spacing": "4mm", "run.until": '"7 s"', "run.average_from": "4"}))
    with h5py.File(result.folder / "results.h5", "r") as file:
        error = lateral_error(file, result.values)
    balance = result.values["force_balance_error"]
    table.rows.append(["condition 2", table.check("condition 2", "U(y)", error, 0.10, f"{100 * error:.1f}"),
                       table.check("condition 2", "force balance", balance, 0.01, f"{100 * balance:.2f}")])
    return table


def space_wide(run):
    """Spheres at their places against the column twin, which knows only the plan mean of their drag."""
    table = Table("Cell of 50 by 43.3 mm, periodic across, dx 3 mm, spheres at their places: against the column twin with the plan mean of their drag",
                  bar_header(space_bars(0.02)) + WIDE_EXTRA)
    for n in CONDITIONS:
        wide_row(table, run, f"wide-{n}", f"condition {n}", n, {}, space_bars(0.02))
    variants = [
        ("2.5mm", "dx 2.5 mm", {"numerics.spacing": "2.5mm"}, 0.02),
        ("slice", "slice form", {"bed.drag_form": "slice"}, 0.04),
        ("thesis", "printed form", {"bed.drag_form": "thesis"}, 0.04),
        ("disordered", "disordered start", {"start.jitter": "0.25"}, 0.03),
        ("stirred", "stirred", STIRRING, 0.03),
    ]
    for name, label, settings, bar in variants:
        wide_row(table, run, f"wide-2-{name}", f"condition 2, {label}", 2, settings, space_bars(bar))
    return table


def space_coarse(run):
    """Half of the width with its side wall against the section twin."""
    table = Table("Half of the width (230 mm) with its side wall, 50 mm long, dx 3 mm (1, 2) and 4 mm (5, 8), against the cross-section twin",
                  bar_header(space_bars(0.02)) + ["U(y) beside the wall, max % (<= 10)", "bed share", "Yang & Lim", "walls' share", "Yang & Lim"])
    channels = [(f"coarse-{n}", f"condition {n}", n, {}) for n in CONDITIONS]
    # Exactly the model of the section twin, in a channel 86.6 mm wide.
    channels.append(("narrow-plan", "condition 2, 86.6 mm wide, plan mean of the drag, 20 s", 2,
                     dict(PLAN_MEAN, **{"channel.width": '"86.6 mm"', "run.until": '"20 s"'})))
    for name, label, n, settings in channels:
        result = complete(run(name, case_file(n, "-coarse"), dict(WINDOW[n], **settings)))
        row_against_bars(table, label, result, space_bars(0.02))
        v = result.values
        with h5py.File(result.folder / "results.h5", "r") as file:
            error = lateral_error(file, v)
            section = dict(file["/section"].attrs.items())
        bed = section["partition_bed_share"]
        table.rows[-1] += [table.check(label, "U(y)", error, 0.10, f"{100 * error:.1f}"),
                           f"{v['drag_over_gravity']:.4f}", f"{bed:.4f}",
                           f"{v['side_wall_over_gravity']:.4f}", f"{1.0 - bed:.4f}"]
    return table


FLUME = "cases/plane-beds/flume.toml"


def plane_sides(run):
    """Plane beds between side walls by the log law, against the section twin and the law of Colebrook."""
    table = Table("Plane beds between side walls by the log law, half of a channel 400 mm wide and 100 mm deep: against the cross-section twin",
                  ["case", "mean U % (<= 2)", "U(y) beside the wall, max % (<= 10)", "walls' share of the weight", "twin", "less, points (<= 2)", "friction/weight - 1, % (<= 1)",
                   "bulk U of the twin over Colebrook's, %"])
    rows = [("gravel-glass", "k_s 5 mm, glass walls, dx 8 mm", {}),
            ("gravel-glass-fine", "the same, dx 5 mm", {"numerics.spacing": '"5 mm"', "channel.length": '"60 mm"'}),
            ("gravel", "k_s 5 mm, walls alike, dx 8 mm", {"side_walls.equivalent_roughness": '"5 mm"'}),
            ("glass", "smooth, dx 8 mm", {"bed.kind": "smooth"}),
            ("narrow", "k_s 2 mm, walls alike, 200 mm wide, dx 5 mm",
             {"bed.equivalent_roughness": '"2 mm"', "side_walls.equivalent_roughness": '"2 mm"', "channel.width": '"200 mm"', "channel.length": '"60 mm"',
              "numerics.spacing": '"5 mm"'})]
    for name, label, settings in rows:
        result = complete(run(f"sides-{name}", FLUME, settings))
        v = result.values
        with h5py.File(result.folder / "results.h5", "r") as file:
            beside = lateral_error(file, v)
            section = dict(file["/section"].attrs.items())
            width, slope = (float(line.split(" = ")[1].split()[0]) for key in ("width", "slope")
                            for line in file["/case/text"][()].decode().split("\n") if line.startswith(f"{key} = "))
        roughness = 0.0 if name == "glass" else 0.002 if name == "narrow" else 0.005
        alike = name != "gravel-glass" and name != "gravel-glass-fine"
        law = colebrook(v["total_depth"], width, slope, roughness)
        share = v["side_wall_over_gravity"] - section["side_wall_share"]
        error = v["total_mean_velocity_error"]
        balance = v["force_balance_error"]
        table.rows.append([label, table.check(label, "mean U", error, 0.02, f"{100 * error:+.2f}"),
                           table.check(label, "U(y)", beside, 0.10, f"{100 * beside:.1f}"),
                           f"{v['side_wall_over_gravity']:.3f}", f"{section['side_wall_share']:.3f}",
                           table.check(label, "walls' share", share, 0.02, f"{100 * share:+.1f}"),
                           table.check(label, "friction over weight", balance, 0.01, f"{100 * balance:+.2f}"),
                           f"{100 * (section['bulk_velocity'] / law - 1):+.1f}" if alike else ""])
    return table


def canals(run):
    """Banks as solids by the log law: a trapezoidal canal, a rectangular one whose walls are solids, a pipe, a compound channel."""
    table = Table("Banks that are solids with the friction of the log law, k_s 1 mm: bulk velocity against Colebrook's with the hydraulic radius; of the compound channel by parts",
                  ["case", "hydraulic radius, mm", "U of the law, m/s", "U of the particles", "% (<= 5; by parts 10)", "friction of the banks over the weight", "friction/weight - 1, % (<= 1)"])
    filled = 2 * math.acos(1 - 0.15 / 0.2)  # angle of the pipe's water
    # Area and wetted perimeter of each part, the upright planes between parts without friction.
    main, plain = (0.275 * 0.075 + 0.35 * 0.075, 0.2 + 2 * math.sqrt(2) * 0.075), (0.125 * 0.075 + 0.5 * 0.075**2, 0.125 + math.sqrt(2) * 0.075)
    concrete, gravel = (0.001,), (0.01,)
    for case, label, parts, bar in (("canal", "banks 1:1, bottom 300 mm", [(0.15 * 0.45, 0.3 + 2 * math.sqrt(2) * 0.15) + concrete], 0.05),
                                    ("canal-upright", "upright banks, bottom 300 mm", [(0.15 * 0.3, 0.6) + concrete], 0.05),
                                    ("pipe", "pipe of 400 mm", [(0.02 * (filled - math.sin(filled)), 0.2 * filled) + concrete], 0.05),
                                    ("canal-compound", "compound, by parts", [main + concrete] + 2 * [plain + concrete], 0.1),
                                    ("canal-rough-floodplains", "compound, by parts, floodplains of 10 mm", [main + concrete] + 2 * [plain + gravel], 0.1)):
        label += ", dx 12 mm"
        area, perimeter = (sum(part[k] for part in parts) for k in (0, 1))
        result = run(case, f"cases/plane-beds/{case}.toml")
        v = result.values
        with h5py.File(result.folder / "results.h5", "r") as file:
            force = file["/probes/standard_force"]
            time = force["time"][:]
            late = (time >= v["window_start"]) & (time <= v["window_end"])
            banks, weight = (force[key][:][late].mean() for key in ("solid_force_1", "weight_component"))
        law = sum(a * colebrook_of(a / p, 0.001, k_s) for a, p, k_s in parts) / area
        error = v["total_mean_velocity"] / law - 1
        balance = v["drag_over_gravity"] + v["wall_over_gravity"] + v["side_wall_over_gravity"] - 1
        table.rows.append([label, f"{1000 * area / perimeter:.1f}", f"{law:.4f}", f"{v['total_mean_velocity']:.4f}",
                           table.check(label, "U against the law", error, bar, f"{100 * error:+.2f}"), f"{banks / weight:.3f}",
                           table.check(label, "friction over weight", balance, 0.01, f"{100 * balance:+.2f}")])
    return table


def colebrook(depth, width, slope, roughness):
    """Of a rectangular channel."""
    return colebrook_of(depth * width / (width + 2 * depth), slope, roughness)


def colebrook_of(radius, slope, roughness, viscosity=1e-6, gravity=9.81):
    """Mean velocity with the hydraulic radius R in place of a quarter of a pipe's diameter."""
    friction_velocity = math.sqrt(gravity * math.sin(math.atan(slope)) * radius)
    return -2 * math.sqrt(8) * friction_velocity * math.log10(roughness / (14.8 * radius) + 2.51 * viscosity / (4 * math.sqrt(8) * radius * friction_velocity))


def space_transient(run):
    """From a power law, far from steady: the particles against the section twin at the same times."""
    settings = {"channel.width": '"86.6 mm"', "bed.drag_form": "plan-mean", "start.kind": "power-law", "start.exponent": "3",
                "start.velocity": '"0.45 m/s"'}
    result = run("narrow-transient", case_file(2, "-coarse"), dict(settings, **{"output.mean_field_interval": '"1 s"', "run.until": '"6 s"'}))
    table = Table("From a power law, half of a channel 86.6 mm wide, dx 3 mm, plan mean of the drag: U(y), means over 1 s, against the section twin",
                  ["time, s", "against the twin at this time, max % (<= 10)", "the twin at this time against its steady state, max %"])
    with h5py.File(result.folder / "results.h5", "r") as file:
        field, datum = file["/mean_field"], result.values["datum"]
        y, above = field["y"][:], field["z"][:] > datum
        for window, time in ((2, 2.5), (5, 5.5)):
            command = [result.command[0], "section", str(result.case), "--time", str(time), "--from", "power-law", "--json", "-"]
            for key, value in settings.items():
                command += ["--set", f"{key}={value}"]
            twin = json.loads(subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout)
            count = field["count"][window].astype(float)
            velocity = numpy.nan_to_num(field["velocity"][window].astype(float))
            u = (count * velocity)[above].sum(axis=(0, 2)) / count[above].sum(axis=(0, 2))
            now, steady = (depth_means(numpy.array(section["y"]), numpy.array(section["z"]), numpy.array(section["velocity"]), datum, y)
                           for section in (twin["transient"]["section"], twin["section"]))
            error = numpy.max(numpy.abs(u / now - 1.0))
            table.rows.append([time, table.check(f"{time} s", "U(y)", error, 0.10, f"{100 * error:.1f}"),
                               f"{100 * numpy.max(numpy.abs(now / steady - 1.0)):.0f}"])
    return table


def depth_means(ys, zs, velocity, datum, y):
    """Means of a section twin's velocity over the height above the datum, at the places y."""
    faces = numpy.concatenate([[0.0], 0.5 * (zs[1:] + zs[:-1]), [2 * zs[-1] - zs[-2]]])
    thickness, high = numpy.diff(faces), zs > datum
    means = (velocity.reshape(zs.size, ys.size)[high] * thickness[high, None]).sum(axis=0) / thickness[high].sum()
    return numpy.interp(y, ys, means)


def lateral_error(file, v):
    """Largest departure of the depth-mean U(y) from the section twin beside the wall, without the first row."""
    field, section = file["/mean_field"], file["/section"]
    time = field["time"][:]
    late = time > v["window_start"] + 1e-6
    late = late if late.any() else time == time[-1]
    count = field["count"][:][late].astype(float)
    velocity = numpy.nan_to_num(field["velocity"][:][late].astype(float))
    y, z = field["y"][:], field["z"][:]
    above = z > v["datum"]
    u = (count * velocity)[:, above].sum(axis=(0, 1, 3)) / count[:, above].sum(axis=(0, 1, 3))
    twin = depth_means(section["y"][:], section["z"][:], section["velocity"][:], v["datum"], y)
    beside = (numpy.arange(y.size) > 0) & (y < v["total_depth"])
    return numpy.max(numpy.abs(u[beside] / twin[beside] - 1.0))


def space_measured(run):
    """Centreline velocity of the coarse runs and of the twin against the flume."""
    table = Table("Centreline depth-mean velocity against the flume (Table 3.1), heights of the thesis' 2D runs, nothing fitted",
                  ["condition", "U measured", "section twin", "%", "particles", "% (<= 10)", "+- 95 %", "level - depth, % of H (<= 1)"])
    for n in CONDITIONS:
        result = complete(run(f"coarse-{n}", case_file(n, "-coarse"), WINDOW[n]))
        v, u = result.values, MEASURED[n][1]
        with h5py.File(result.folder / "results.h5", "r") as file:
            twin = float(file["/section"].attrs["centreline_velocity"])
        name = f"condition {n}"
        level = v["mean_level"] / v["total_depth"] - 1.0
        table.rows.append([n, f"{u:.2f}", f"{twin:.3f}", f"{100 * (twin / u - 1):+.1f}", f"{v['centreline_velocity']:.3f}",
                           table.check(name, "U", v["centreline_velocity"] / u - 1.0, 0.10, f"{100 * (v['centreline_velocity'] / u - 1):+.1f}"),
                           half_width(v, "centreline_velocity"), table.check(name, "level", level, 0.01, f"{100 * level:+.2f}")])
    return table


SPACE_PARTS = {"space_twin": space_twin, "space_side_quick": space_side_quick, "space_wide": space_wide,
               "space_coarse": space_coarse, "plane_sides": plane_sides, "canals": canals, "space_transient": space_transient, "space_measured": space_measured}
SPACE = ["space_twin", "space_wide", "space_coarse", "plane_sides", "canals", "space_transient", "space_measured"]
