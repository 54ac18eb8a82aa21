"""A table of values against bars: text for the terminal, Markdown for the documents."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

import known_misses  # noqa: E402


class Cell:
    """A value with its bar; what it is worth is known when the table is judged."""

    MARKS = {"held": "", "known": " (known miss)", "missed": " !"}

    def __init__(self, row, label, value, bar, shown):
        self.row, self.label, self.value, self.bar, self.shown, self.verdict = row, label, value, bar, shown, "held"

    def __str__(self):
        return self.shown + self.MARKS[self.verdict]


class Table:
    def __init__(self, title, header):
        self.title, self.header, self.rows, self.missed, self.known, self.checks, self.cells = title, header, [], [], [], 0, []

    def check(self, row, label, value, bar, shown):
        """Cell of a value that must not exceed its bar in magnitude."""
        self.checks += 1
        self.cells.append(Cell(row, label, value, bar, shown))
        return self.cells[-1]

    def judge(self, suite, part, misses=None):
        """Hold the values against their bars and the known misses; part: the name of what made the table."""
        misses = known_misses.read() if misses is None else misses
        seen = set()
        for cell in self.cells:
            key = (suite, part, cell.row, cell.label)
            if key in seen:
                raise ValueError(f"two values are called {key}")
            seen.add(key)
            cell.verdict, text = known_misses.judge(misses, key, cell.value, cell.bar)
            {"held": [], "known": self.known, "missed": self.missed}[cell.verdict].append(text)
        self.missed += [f"{name} is a known miss, but no such value came up" for name in known_misses.unseen(misses, suite, seen)]

    def text(self):
        cells = [[str(cell) for cell in line] for line in [self.header] + self.rows]
        widths = [max(len(line[i]) for line in cells) for i in range(len(self.header))]
        return "\n".join([f"\n{self.title}"] + ["  ".join(cell.rjust(width) for cell, width in zip(line, widths)) for line in cells])

    def markdown(self):
        lines = [f"## {self.title}\n", "| " + " | ".join(self.header) + " |", "|" + "---|" * len(self.header)]
        return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in self.rows]) + "\n"
