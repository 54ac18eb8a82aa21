#!/usr/bin/env python3
"""The bars that are known to be missed (known_misses.toml): how bad each may be, and why it is missed.

  tests/known_misses.py                 print docs/known-misses.md
  tests/known_misses.py --check FILE    status 1 unless FILE is what it prints

A suite asks judge() about each value that misses its bar, and about each entry: a miss that nobody knows of fails the suite; so
does a known one that has become worse, and one that has gone, whose entry must go too."""

import argparse
import math
import pathlib
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
KEYS = {"suite", "part", "row", "quantity", "bar", "value", "worst", "reason"}
OPTIONAL = {"may_hold"}

# A value that comes to hold its bar by less than this share of it may miss it again on the next machine.
CLEAR = 0.9


class Miss:
    def __init__(self, entry, place):
        if set(entry) - OPTIONAL != KEYS:
            sys.exit(f"{place}: an entry has the keys {', '.join(sorted(KEYS))}; this one {', '.join(sorted(entry))}")
        # Of the largest sample in one run of a flow that never repeats: on another machine it may hold its bar.
        self.may_hold = False
        self.__dict__.update(entry)
        if not (abs(self.worst) >= abs(self.value) > self.bar):
            sys.exit(f"{place}: {self.row}, {self.quantity}: expected bar < value <= worst, here {self.bar}, {self.value}, {self.worst}")

    @property
    def key(self):
        return (self.suite, self.part, self.row, self.quantity)

    def __str__(self):
        return f"{self.suite} {self.part}, {self.row}: {self.quantity}"


def statements(path=HERE / "known_misses.toml"):
    """What departs from a measurement without a bar that would say how much it may: (text, command)."""
    with open(path, "rb") as file:
        return [(entry["text"], entry["command"]) for entry in tomllib.load(file).get("without_a_bar", [])]


def read(path=HERE / "known_misses.toml"):
    with open(path, "rb") as file:
        entries = tomllib.load(file).get("miss", [])
    misses = {}
    for number, entry in enumerate(entries, 1):
        miss = Miss(entry, f"{path}, [[miss]] {number}")
        if miss.key in misses:
            sys.exit(f"{path}: {miss} stands there twice")
        misses[miss.key] = miss
    return misses


def judge(misses, key, value, bar):
    """("held" | "known" | "missed", what to say or ""): of a value with its bar and the key (suite, part, row, quantity)."""
    miss, name = misses.get(key), f"{key[0]} {key[1]}, {key[2]}: {key[3]}"
    held = math.isfinite(value) and abs(value) <= bar
    if miss is None:
        return ("held", "") if held else ("missed", f"{name} is {value:.4g}, bar {bar:g}")
    if abs(miss.bar - bar) > 1e-9 * bar:
        return "missed", f"{name}: its bar is {bar:g}, in known_misses.toml {miss.bar:g}"
    if held and abs(value) < CLEAR * bar and not miss.may_hold:
        return "missed", f"{name} is {value:.4g} and holds its bar {bar:g} now: take it out of tests/known_misses.toml"
    if held:
        return "held", ""
    if not abs(value) <= miss.worst:
        return "missed", f"{name} is {value:.4g}, worse than the {miss.worst:g} that is known (bar {bar:g})"
    return "known", f"{name} is {value:.4g}, bar {bar:g}: {miss.reason}"


def unseen(misses, suite, seen):
    """Entries of the parts of a suite that were run, of which no value came up."""
    parts = {key[1] for key in seen if key[0] == suite}
    return [str(miss) for key, miss in misses.items() if key[0] == suite and key[1] in parts and key not in seen]


def page(misses, remarks=()):
    lines = ["# Known misses", "",
             "Every bar of the suites that is missed, with the reason; nothing else is. `./run-tests.sh --long` prints the values of",
             "today, and fails when one becomes worse than the last column but one, when another bar is missed, or when one of these",
             "has come to hold and still stands here (but where it may: an extreme of one run of a flow that never repeats). This page is what `tests/known_misses.py` prints of `tests/known_misses.toml`.", ""]
    suites = {}
    for miss in misses.values():
        suites.setdefault((miss.suite, miss.part), []).append(miss)
    for (suite, part), entries in suites.items():
        program = {"validation": "validate.py ", "verification": "verify.py "}.get(suite, "")
        command = f"tests/{suite}/{program}{part}"
        lines += [f"## `{command}`", "", "| case | quantity | bar | measured | fails above | reason |", "|---|---|---|---|---|---|"]
        lines += [f"| {m.row} | {m.quantity} | {m.bar:g} | {m.value:g} | {m.worst:g} | {m.reason}{' (may hold)' if m.may_hold else ''} |" for m in entries]
        lines.append("")
    if not suites:
        lines += ["There is none.", ""]
    if remarks:
        lines += ["## Without a bar", ""]
        for text, command in remarks:
            lines += [f"- {text}", f"  `{command}`"]
        lines.append("")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", type=pathlib.Path)
    arguments = parser.parse_args()
    text = page(read(), statements())
    if arguments.check is None:
        print(text, end="")
    elif not arguments.check.exists() or arguments.check.read_text() != text:
        sys.exit(f"{arguments.check} is not what tests/known_misses.py prints: tests/known_misses.py > {arguments.check}")


if __name__ == "__main__":
    main()
