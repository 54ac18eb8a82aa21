#!/usr/bin/env python3
"""No switch over an option of the case has `default:`.

  tests/check_switches.py ROOT

Where a switch lists all enumerators the compiler names each place that a new option needs (-Wswitch); where it ends with
`default:` the new option does silently what another does. Options are the enumerations of src/case/options.hpp."""

import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
OPTIONS = set(re.findall(r"enum class (\w+)", (ROOT / "src/case/options.hpp").read_text()))


def body_of(text, start):
    """The text from the brace at or after a place to the one that closes it."""
    begin = text.index("{", start)
    depth = 0
    for end in range(begin, len(text)):
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        if depth == 0:
            return text[begin : end + 1]
    return text[begin:]


def without_inner(body):
    """A switch's body without the switches within it."""
    while inner := re.search(r"\bswitch \(", body[1:]):
        within = body_of(body, inner.start() + 1)
        body = body.replace(within, "", 1)[: inner.start() + 1] + body.replace(within, "", 1)[inner.end() + 1 :]
    return body


faults = 0
switches = 0
for source in sorted((ROOT / "src").rglob("*.[ch]pp")):
    text = source.read_text()
    for found in re.finditer(r"\bswitch \(", text):
        body = without_inner(body_of(text, found.start()))
        options = {option for option in re.findall(r"case (\w+)::", body) if option in OPTIONS}
        switches += bool(options)
        if options and re.search(r"\bdefault:", body):
            line = text.count("\n", 0, found.start()) + 1
            print(f"{source.relative_to(ROOT)}:{line}: the switch over {', '.join(options)} has `default:`; list the enumerators that it stands for")
            faults += 1
if not faults:
    print(f"each of {switches} switches over options lists its enumerators")
sys.exit(1 if faults else 0)
