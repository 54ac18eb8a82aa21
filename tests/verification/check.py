"""One case of the verification: error norms against bars, figures, budgets, and how it was best run."""

import numpy

from flow import Energy, lost_mass, momentum_budget
from table import Table, known_misses


class Check:
    """`name` is that of the command line; `text` says what is exact about the case."""

    def __init__(self, name, title, text):
        self.name, self.title, self.text = name, title, text
        self.norms = []  # (label, bar or None, value, text of the value, text of the bar)
        self.verdicts = {}  # of the labels with bars, by judge(): held, known or missed, and what to say
        self.figures, self.budgets, self.tables, self.remarks = [], [], [], []
        self.best, self.cost = "", ""
        self.closing = {}  # the budgets in short, by the heads of the table of all cases

    def norm(self, label, value, bar=None, unit="%", digits=2):
        """An error that must not exceed its bar in magnitude; without a bar it is stated only. Percent are given as fractions."""
        factor = 100 if unit == "%" else 1
        shown = lambda v: f"{factor * v:.{digits}g}" + (f" {unit}" if unit else "")
        self.norms.append((label, bar, value, shown(value), "" if bar is None else shown(bar)))

    def budget(self, quantity, value, statement, limit=None):
        """A budget; more than `limit` is a missed bar, and a row of the table of all checks then."""
        self.budgets.append((quantity, statement, f"{value:.2g}" if isinstance(value, float) else value))
        if limit is not None and not abs(value) <= limit:
            self.norms.append((f"budget of {quantity}: {statement}", limit, value, f"{value:.1e}", f"{limit:.0e}" if limit else "0"))

    def budgets_of(self, flow, energy=True, vertical=True):
        """Mass, momentum and energy of a run."""
        lost = float(lost_mass(flow))
        self.closing["mass lost"] = f"{lost:.1g}"
        self.budget("mass", lost, "share of the particles lost (their masses are constant)", 0.0)
        along, upright, scale = momentum_budget(flow)
        if flow.forces:
            scale += f" (sampled at {(len(flow.forces['time']) - 1) / (flow.forces['time'][-1] - flow.forces['time'][0]):.3g} Hz)"
        self.closing["momentum along x"] = f"{along:.1e}"
        self.budget("momentum", float(along), f"along x: change less the forces' impulse, over the {scale}")
        if vertical:
            self.closing["along z"] = f"{upright:.1e}"
            self.budget("momentum", float(upright), "along z: the same, over the impulse of the weight" if flow.forces and flow.gravity_z else "along z: the same")
        return self.energy_budget(flow) if energy else None

    def energy_budget(self, flow, snapshots=41):
        e = Energy(flow, snapshots)
        # Between end walls the work of the weight comes back.
        driven = numpy.abs(e.weight).max() if flow.periods[0] else 0.0
        available = max(e.kinetic.max(), driven, 1e-300)
        gained, worked = (e.total[-1] - e.total[0] - e.weight[-1]) / available, -e.dissipation[-1] / available
        self.closing |= {"energy": f"{gained:+.3f}", "work of viscosity": f"{worked:+.3f}", "left": f"{e.balance[-1] / available:+.3f}"}
        self.budget("energy", f"{gained:+.3f}",
                    "change of kinetic, potential and elastic energy less the work of the weight, over the largest kinetic energy, or in a channel that work if it is more")
        self.budget("energy", f"{worked:+.3f}", "work of viscosity, from the velocity gradients in the snapshots, over the same")
        self.budget("energy", f"{e.balance[-1] / available:+.3f}", "what is left: gained (+) or lost (-) by the scheme and by the sampling")
        return e

    def judge(self, misses=None, complete=False):
        """Hold the norms against their bars and the known misses; `complete`: with all spacings, so that none may lack."""
        misses = known_misses.read() if misses is None else misses
        seen = set()
        for label, bar, value, *_ in self.norms:
            if bar is None:
                continue
            key = ("verification", self.name, self.title, label)
            if key in seen:
                raise ValueError(f"two norms are called {key}")
            seen.add(key)
            self.verdicts[label] = known_misses.judge(misses, key, value, bar)
        self.missed = [text for verdict, text in self.verdicts.values() if verdict == "missed"]
        self.known = [text for verdict, text in self.verdicts.values() if verdict == "known"]
        if complete:
            self.missed += [f"{name} is a known miss, but no such value came up" for name in known_misses.unseen(misses, "verification", seen)]
        return self

    def rows(self):
        """Rows of the table of all checks; a missed bar is marked with !, one that is known to be missed with (fails)."""
        for i, norm in enumerate(self.norms):
            mark = {"held": "", "known": " (fails)", "missed": " !"}[self.verdicts.get(norm[0], ("held", ""))[0]]
            yield [self.title if i == 0 else "", norm[0], norm[4] or "stated", norm[3] + mark, self.best if i == 0 else "", self.cost if i == 0 else ""]


def text(check):
    """The norms of one check, for the terminal."""
    table = Table(check.title, HEADER[1:4])
    table.rows = [row[1:4] for row in check.rows()]
    return table.text() + f"\n{check.best}; {check.cost}"


HEADER = ["case", "error norm", "bar", "measured", "best option set", "cost"]


def summary_table(checks):
    table = Table("Verification", HEADER)
    for check in checks:
        table.rows += list(check.rows())
        table.checks += sum(norm[1] is not None for norm in check.norms)
        table.missed += check.missed
    return table


def budget_table(checks):
    heads = ["mass lost", "momentum along x", "along z", "energy", "work of viscosity", "left"]
    table = Table("Budgets", ["case"] + heads)
    table.rows = [[check.title] + [check.closing.get(head, "") for head in heads] for check in checks if check.closing]
    return table
