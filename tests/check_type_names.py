#!/usr/bin/env python3
"""No two files define types of the same name in the same namespace, those of rooms, which are inline, taken as one.

  tests/check_type_names.py ROOT

The linker keeps one of two functions that have the same name, so that a program with two such types may destroy the one
with the destructor of the other; compilers do not tell. Of two rooms they would be two types, but a file that sees both could name neither. What stands in a namespace without a name cannot meet."""

import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
# A type that one file declares and another completes is one.
DEFINITION = re.compile(r"(?:struct|class) (\w+)(?: final)?(?: : [^;]*)?(?: \{|$)")


def types_of(path):
    """Names with their namespaces of the types that a file defines."""
    spaces, hidden, found = [], False, set()
    for line in path.read_text().splitlines():
        if opened := re.match(r"namespace ([\w:]+?)(?:::inline \w+)?(::\w+)? \{", line):
            spaces.append(opened.group(1) + (opened.group(2) or ""))
        elif line == "namespace {":
            hidden = True
        elif line == "}  // namespace":
            hidden = False
        elif re.match(r"\}  // namespace \S", line):
            spaces.pop()
        elif not hidden and (defined := DEFINITION.match(line)):
            found.add("::".join([*spaces, defined.group(1)]))
    return found


places = collections.defaultdict(list)
for source in sorted((ROOT / "src").rglob("*.[ch]pp")):
    for name in types_of(source):
        places[name].append(source.relative_to(ROOT))
twice = {name: files for name, files in places.items() if len(files) > 1}
for name, files in sorted(twice.items()):
    print(f"{name} is defined in {' and in '.join(map(str, files))}: give one of them another name")
if not twice:
    print(f"each of {len(places)} types has one definition")
sys.exit(1 if twice else 0)
