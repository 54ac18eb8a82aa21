"""The report page of the verification: one HTML file without any other."""

import html

STYLE = """
body{font:15px/1.5 system-ui,sans-serif;color:#222;background:#fff;max-width:72rem;margin:2rem auto;padding:0 1rem}
h1{font-size:1.7rem}h2{font-size:1.2rem;margin-top:2.6rem;border-top:1px solid #ddd;padding-top:1rem}h3{font-size:1rem}
table{border-collapse:collapse;font-size:.86rem;margin:.8rem 0;display:block;overflow-x:auto}
th,td{padding:.25rem .6rem;text-align:left;vertical-align:top;border-bottom:1px solid #e6e6e6}th{background:#f4f6f8}
.held{color:#22662b}.missed{color:#b3261e;font-weight:600}.stated{color:#666}figure{margin:1rem 0}figcaption{font-size:.86rem;color:#555}
svg{max-width:100%;height:auto}code{background:#f4f6f8;padding:0 .25em}a{color:#1b6ca8}p{max-width:52rem}
"""


def _cell(value, tag="td", style=""):
    return f"<{tag}{f' class={style}' if style else ''}>{html.escape(str(value))}</{tag}>"


def _table(header, rows, styles=None):
    lines = ["<table><thead><tr>" + "".join(_cell(h, "th") for h in header) + "</tr></thead><tbody>"]
    for r, row in enumerate(rows):
        lines.append("<tr>" + "".join(_cell(c, "td", styles(r, i, row) if styles else "") for i, c in enumerate(row)) + "</tr>")
    return "\n".join(lines) + "</tbody></table>"


def _verdict(_, column, row):
    if column != 3:
        return ""
    return "missed" if row[3].endswith(("!", "(fails)")) else "stated" if row[2] == "stated" else "held"


def html_page(table, budgets, checks, build):
    known = sum(len(c.known) for c in checks)
    held = table.checks - len(table.missed) - known
    parts = ["<!DOCTYPE html><html lang=en><head><meta charset=utf-8><meta name=viewport content='width=device-width,initial-scale=1'>"
             f"<title>Riffle: verification</title><style>{STYLE}</style></head><body><h1>Riffle against exact solutions and published "
             f"measurements</h1><p>{html.escape(build)}. <strong>{held} of {table.checks} bars held, {known} known to fail.</strong> Bars "
             "were given before the runs; values without one are stated. <span class=missed>!</span> marks what misses its bar, "
             "<span class=missed>(fails)</span> what is known to, for the reason given with the case. Every figure shows the exact "
             "solution (or the measurement) as a line and the particles as points unless it says otherwise.</p>"]
    parts.append(_table(table.header, table.rows, _verdict))
    parts.append("<h3>Budgets</h3><p>Particles lost; change of momentum less the impulse of all forces, over that of their magnitudes; change of "
                 "energy less the work of the weight, the work of viscosity, and what is left of them (the scheme's own, and the sampling's), over the "
                 "largest kinetic energy or the work of the weight.</p>" + _table(budgets.header, budgets.rows))
    parts.append("<p>" + " · ".join(f"<a href='#{c.name}'>{html.escape(c.title)}</a>" for c in checks) + "</p>")
    for check in checks:
        parts.append(f"<h2 id='{check.name}'>{html.escape(check.title)}</h2><p>{check.text}</p>")
        for drawing, caption in check.figures:
            parts.append(f"<figure>{drawing}<figcaption>{html.escape(caption)}</figcaption></figure>")
        for extra in check.tables:
            parts.append(f"<h3>{html.escape(extra.title)}</h3>" + _table(extra.header, extra.rows))
        if check.budgets:
            parts.append("<h3>Budgets</h3>" + _table(["budget", "measure", "value"], check.budgets))
        for remark in check.remarks:
            parts.append(f"<p>{html.escape(remark)}</p>")
        if check.cost:
            parts.append(f"<p>Best option set: {html.escape(check.best)}. Cost: {html.escape(check.cost)}.</p>")
    return "\n".join(parts) + "</body></html>\n"


def markdown(table, budgets, checks):
    """The tables of all checks, then the further tables of each."""
    return "\n".join([table.markdown(), budgets.markdown()] + [extra.markdown() for check in checks for extra in check.tables])
