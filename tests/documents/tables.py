#!/usr/bin/python3
"""Print tables of the documentation as Markdown, from what `riffle` says now (the program is looked for in PATH, the
cases in cases/).

Usage: tables.py column-conditions | column-fit-range | section-start | section-heights"""
import json
import math
import subprocess
import sys

CONDITIONS = range(1, 9)


def riffle(*arguments):
    return json.loads(subprocess.run(["riffle", *arguments], check=True, capture_output=True, text=True).stdout)


def case_of(condition):
    return f"cases/rough-bed-2d/condition-{condition}.toml"


def against(value, reference):
    return f"{100 * (value / reference - 1):+.1f} %"


def column_conditions():
    """The column twin of each flow condition beside the measured values: docs/column.md."""
    print("| condition | U measured | U column | | u_* measured | u_* stress | | u_* fit | | k_s measured | k_s fit | e-folding time |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|")
    for condition in CONDITIONS:
        twin = riffle("column", case_of(condition), "--json")
        measured, fit = twin["measured"], twin["log_law"]
        u, star, ks = measured["depth_mean_velocity"], measured["friction_velocity"], measured["equivalent_roughness"]
        print(f"| {condition}{'*' if condition == 4 else ''} | {u:.2f} m/s | {twin['depth_mean_velocity']:.3f} m/s "
              f"| {against(twin['depth_mean_velocity'], u)} | {star:.3f} m/s | {twin['friction_velocity']:.4f} m/s "
              f"| {against(twin['friction_velocity'], star)} | {fit['friction_velocity']:.4f} m/s "
              f"| {against(fit['friction_velocity'], star)} | {1000 * ks:.0f} mm | {1000 * fit['equivalent_roughness']:.1f} mm "
              f"| {twin['relaxation_time']:.1f} s |")


def slope_of_log_law(z, u, datum, low, high):
    """Friction velocity of the least-squares line of u over ln(z - datum) from low to high, evenly in z."""
    n = 400
    points = [low + (high - low) * (i + 0.5) / n for i in range(n)]
    x = [math.log(p - datum) for p in points]
    y, at = [], 0
    for p in points:
        while z[at + 1] < p:
            at += 1
        y.append(u[at] + (u[at + 1] - u[at]) * (p - z[at]) / (z[at + 1] - z[at]))
    mean_x, mean_y = sum(x) / n, sum(y) / n
    slope = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)
    return 0.41 * slope


def column_fit_range():
    """Error of the fitted u_* for other ranges of the fit: docs/column.md."""
    shares = (0.4, 0.5, 0.6, 0.7, 0.8, 1.0)
    errors = {share: [] for share in shares}
    for condition in CONDITIONS:
        if condition == 4:
            continue
        twin = riffle("column", case_of(condition), "--json")
        z, u = twin["profile"]["z"], twin["profile"]["u"]
        depth = z[-1] + z[0]
        datum = twin["log_law"]["zero_plane"]
        crest, star = twin["log_law"]["from"], twin["measured"]["friction_velocity"]
        water = round(depth - datum, 6)
        for share in shares:
            high = min(datum + share * water, z[-1])
            errors[share].append(slope_of_log_law(z, u, datum, crest, high) / star - 1)
    print("| " + " | ".join(("**0.7 h_w**" if s == 0.7 else "surface" if s == 1.0 else f"{s} h_w") for s in shares) + " |")
    print("|" + "---|" * len(shares))
    cells = [f"{100 * min(errors[s]):+.0f} to {100 * max(errors[s]):+.0f} %" for s in shares]
    print("| " + " | ".join(f"**{cell}**" if s == 0.7 else cell for s, cell in zip(shares, cells)) + " |")


CHANNEL = ["--set", "channel.dimensions=3", "--set", "channel.sides=half", "--set",
           "turbulence.closure=czernuszenko-rylov"]
EXPONENTS = {1: 2.8, 2: 3.0, 5: 3.2, 8: 3.8}
SQUARE = {8: ["--set", "start.lattice=square"]}


def section_start():
    """How far six seconds from a power law come: docs/section.md."""
    print("| condition | depth mean at the centreline | mean over the section | mean in the walls' layers |")
    print("|---|---|---|---|")
    for condition, exponent in EXPONENTS.items():
        twin = riffle("section", case_of(condition), *CHANNEL, *SQUARE.get(condition, []), "--set", "start.kind=power-law",
                      "--set", f"start.exponent={exponent}", "--time", "6", "--from", "power-law", "--json", "-")
        later = twin["transient"]
        cells = []
        for key in ("centreline_velocity", "depth_mean_velocity", "wall_layer_velocity"):
            cells.append(f"{later[key]:.4g} / {against(later[key], twin[key])}, {later['approach_time'][key]:.0f} s")
        print(f"| {condition} | " + " | ".join(cells) + " |")


def section_heights():
    """The centreline of the section beside the measured U, and the roughness height that meets it: docs/section.md."""
    in_space = {1: 0.32, 2: 0.32, 5: 0.24, 8: 0.24}
    in_plane = {1: 0.40, 2: 0.40, 5: 0.40, 8: 0.32}
    print("| drag form | condition | U | height of the thesis in 2D | height of the thesis in 3D | height that meets U |")
    print("|---|---|---|---|---|---|")
    for form, name in (("consistent", "volume (`consistent`)"), ("slice", "slice (`slice`)")):
        for condition in EXPONENTS:
            settings = [case_of(condition), *CHANNEL, *SQUARE.get(condition, []), "--set", f"bed.drag_form={form}"]
            cells = []
            for height in (in_plane[condition], in_space[condition]):
                twin = riffle("section", *settings, "--set", f'bed.roughness_height="{height} D"', "--json", "-")
                u = twin["measured"]["depth_mean_velocity"]
                cells.append(f"{height:.2f} D: {twin['centreline_velocity']:.4f} ({against(twin['centreline_velocity'], u)})")
            fitted = riffle("calibrate", *settings, "--fit", "roughness_height", "--friction-uncertainty", "1000",
                            "--profile-uncertainty", "1000", "--json")["parameters"][0]["value"]
            print(f"| {name} | {condition} | {u:.2f} | {cells[0]} | {cells[1]} | {fitted / 0.025:.2f} D = {1000 * fitted:.1f} mm |")


def main():
    tables = {"column-conditions": column_conditions, "column-fit-range": column_fit_range,
              "section-start": section_start, "section-heights": section_heights}
    if len(sys.argv) != 2 or sys.argv[1] not in tables:
        print(__doc__, file=sys.stderr)
        return 2
    tables[sys.argv[1]]()
    return 0


if __name__ == "__main__":
    sys.exit(main())
