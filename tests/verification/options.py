"""What a case was run with, in words, and comparisons of option sets and spacings."""

import re

import exact
from table import Table


def _amount(text):
    """A length such as "2 mm" or 0.01 in m."""
    number, unit = re.fullmatch(r'"?([0-9.eE+-]+)\s*(um|mm|cm|m)?"?', str(text)).groups()
    return float(number) * {"um": 1e-6, "mm": 1e-3, "cm": 1e-2, "m": 1.0, None: 1.0}[unit]


def options_text(flow):
    """The options that matter, from the case that the results hold."""
    n = flow.parameters["numerics"]
    parts = [n["kernel"], f"h = {n['smoothing_ratio']:g} dx", f"{n['pressure_form']} pressure", n["viscosity"]]
    parts.append(f"{n['density_diffusion']}" + (f" {n['density_diffusion_coefficient']:g}" if n["density_diffusion"] != "none" else " density diffusion"))
    parts.append(n["stepping"])
    if n.get("reference_pressure", "none") != "none":
        parts.append(f"{n['reference_pressure']} reference pressure")
    start = flow.parameters["start"]
    if start["lattice"] != "square":
        parts.append(start["lattice"])
    if start["jitter"]:
        parts.append(f"jitter {start['jitter']:g}")
    return ", ".join(parts)


def compare_options(study, check, case, variants, flow, measure, label, base=None):
    """A table of option sets at the case's spacing: the error of `measure`, and the cost; the smallest error makes the best set.

    `settings` of a variant are keys of the case; `base` holds what all of them and `flow` have been given.
    """
    rows = [("as the case", measure(flow), flow)]
    own = lambda key: flow.parameters[key.split(".")[0]][key.split(".")[1]]
    for name, settings in variants.items():
        if all(str(own(key)).removesuffix(".0") == value for key, value in settings.items()):
            continue  # the case itself
        other = study.try_run(f"{check.name}-{re.sub('[^a-z0-9.]+', '-', name.lower())}", case, {**(base or {}), **settings})
        rows.append((name, measure(other) if other else None, other))
    best = min((row for row in rows if row[1] is not None), key=lambda row: row[1])
    check.best = f"{options_text(best[2])} ({best[0]})"
    table = Table(f"{check.title}: option sets", ["option set", f"{label} %", "s of a core"])
    table.rows = [[name, "fails" if value is None else f"{100 * value:.3g}", "" if value is None else f"{other.cost:.1f}"] for name, value, other in rows]
    check.tables.append(table)


def refinement(study, check, case, spacings, measure, label, settings=None):
    """A table of spacings with the observed order of an error norm."""
    errors, rows = [], []
    for spacing in spacings:
        flow = study.run(f"{check.name}-{spacing.replace(' ', '')}", case, {"numerics.spacing": f'"{spacing}"', **(settings or {})})
        errors.append(measure(flow))
        rows.append([spacing, f"{100 * errors[-1]:.3g}", f"{flow.cost:.1f}"])
    order = exact.observed_order([_amount(s) for s in spacings], errors)
    table = Table(f"{check.title}: spacings (observed order {order:.2f})", ["spacing", f"{label} %", "s of a core"])
    table.rows = rows
    check.tables.append(table)
    check.norm(f"observed order of the {label.split(' / ')[0]}", order, None, "")
