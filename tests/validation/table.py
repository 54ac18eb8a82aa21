"""A table of values against bars: text for the terminal, Markdown for the documents."""

import math


class Table:
    def __init__(self, title, header):
        self.title, self.header, self.rows, self.missed, self.checks = title, header, [], [], 0

    def check(self, row, label, value, bar, shown):
        """Text of a value that must not exceed its bar in magnitude; a miss is marked and remembered."""
        self.checks += 1
        held = math.isfinite(value) and abs(value) <= bar
        if not held:
            self.missed.append(f"{self.title}, {row}: {label} {shown}")
        return shown if held else f"{shown} !"

    def text(self):
        widths = [max(len(str(line[i])) for line in [self.header] + self.rows) for i in range(len(self.header))]
        lines = [f"\n{self.title}"]
        for line in [self.header] + self.rows:
            lines.append("  ".join(str(cell).rjust(width) for cell, width in zip(line, widths)))
        return "\n".join(lines)

    def markdown(self):
        lines = [f"## {self.title}\n", "| " + " | ".join(self.header) + " |", "|" + "---|" * len(self.header)]
        return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in self.rows]) + "\n"
