#!/usr/bin/env python3
"""Check that each file of src/ includes only headers of rooms that its room may use, and is in its room's namespace.

The rooms and what they use are read from the lines riffle_room(NAME ROOMS ...) of CMakeLists.txt. A room may use its
own headers and those of the rooms it names; it may name only rooms declared before it. All of a file of room NAME
stands in `namespace riffle::inline NAME`, in `riffle::inline case_file` for the room case, whose name is a keyword.

Usage: tests/check_rooms.py [REPOSITORY]
"""
import pathlib
import re
import sys


def rooms(text):
    """Room -> rooms it names, in the order of CMakeLists.txt."""
    result = {}
    for name, arguments in re.findall(r"^riffle_room\(\s*(\w+)([^)]*)\)", text, re.MULTILINE):
        words = arguments.split()
        named = []
        if "ROOMS" in words:
            for word in words[words.index("ROOMS") + 1:]:
                if word in ("LINK", "EXECUTABLE"):
                    break
                named.append(word)
        result[name] = named
    return result


def namespace_faults(path, room):
    """What is wrong with the namespaces of a file, (line, sentence)."""
    name = {"case": "case_file"}.get(room, room)
    opened = None
    for number, line in enumerate(path.read_text().splitlines(), 1):
        begin = re.match(r"namespace (riffle\S*(?: \S+)?) \{$", line)
        end = re.match(r"\}  // namespace (riffle.*)$", line)
        if begin:
            opened = begin[1]
            if not re.fullmatch(rf"riffle::inline {name}(::\w+)*", opened):
                yield number, f"opens namespace {opened}, not riffle::inline {name}"
        if end and end[1] != opened:
            yield number, f"closes namespace {end[1]}, but {opened or 'none'} is open"
        if end:
            opened = None
    if opened:
        yield number, f"does not close namespace {opened} by a line }}  // namespace {opened}"


def faults(repository):
    """What is wrong, one line each."""
    allowed = rooms((repository / "CMakeLists.txt").read_text())
    if not allowed:
        yield "CMakeLists.txt: no riffle_room(...) found"
    above = set()
    for room, named in allowed.items():
        for other in named:
            if other not in above:
                yield f"CMakeLists.txt: room {room} names {other}, which is not declared above it"
        above.add(room)
    source = repository / "src"
    for folder in sorted(path.name for path in source.iterdir() if path.is_dir()):
        if folder not in allowed and any((source / folder).iterdir()):
            yield f"src/{folder}: no riffle_room({folder} ...) in CMakeLists.txt"
    for path in sorted(source.rglob("*.?pp")):
        room = path.relative_to(source).parts[0]
        for number, fault in namespace_faults(path, room):
            yield f"{path.relative_to(repository)}:{number}: {fault}"
        for number, line in enumerate(path.read_text().splitlines(), 1):
            include = re.match(r'\s*#\s*include\s*["<](\w+)/', line)
            if not include or include[1] not in allowed:
                continue
            if include[1] != room and include[1] not in allowed.get(room, []):
                yield (f"{path.relative_to(repository)}:{number}: room {room} may not use {include[1]}; "
                       f"it may use {', '.join(allowed.get(room, [])) or 'no other room'} (CMakeLists.txt)")


def main():
    repository = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)
    found = list(faults(repository.resolve()))
    print("\n".join(found) if found else "every include is of a room that may be used, every file in the namespace of its room")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
