#!/usr/bin/env python3
"""The brace style of Riffle's C++, where clang-format has no say: one short statement stands without braces on the
line of its if, for or while; every other body, and all of an if with an else, has braces.

  tools/brace_style.py [--fix] FILE...

Prints each place of another style and ends with 1; --fix joins short bodies to their lines and leaves the rest.
"""
import pathlib
import re
import sys

LONGEST_LINE = 110
CONTROL = re.compile(r"\s*(\} else )?(if|for|while) (constexpr )?\(")
OPENING = re.compile(r"\s*(if|for|while) (?:constexpr )?\(.*\) \{$")


def balanced(text):
    """Whether each parenthesis of a line is closed on it."""
    return text.count("(") == text.count(")") and "//" not in text


def end_of_condition(lines, i):
    """The line where the parenthesis closes that line i opens, and what follows it there."""
    depth = 0
    for end in range(i, len(lines)):
        text = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])\'', lambda found: "s" * len(found[0]), lines[end].split(" //")[0])
        for place, letter in enumerate(text):
            depth += {"(": 1, ")": -1}.get(letter, 0)
            if letter == ")" and depth == 0:
                return end, text[place + 1:].strip()
    return len(lines), "{"


def short_body(lines, i):
    """The joined line, where line i opens a body of one short statement; None where it does not."""
    if i + 2 >= len(lines) or not OPENING.match(lines[i]) or not balanced(lines[i]):
        return None
    indent = lines[i][: len(lines[i]) - len(lines[i].lstrip())]
    body = lines[i + 1].strip()
    if lines[i + 2] != indent + "}" or not body.endswith(";") or not balanced(body) or "{" in lines[i][:-1]:
        return None
    if re.match(r"(if|for|while|do|switch|else|case)\b", body) or body.count(";") > 1 or "{" in body:
        return None
    if re.match(r"\s*if\b", lines[i]) and re.match(r"(EXPECT|ASSERT)_", body):
        return None  # macros that hold an if with an else
    joined = lines[i][:-1] + body
    return joined if len(joined) <= LONGEST_LINE else None


def faults(lines):
    """(line number, what is wrong) of a file, counted from 1."""
    for i, line in enumerate(lines):
        if short_body(lines, i):
            yield i + 1, "write the short body on this line, without braces"
        end, rest = end_of_condition(lines, i) if CONTROL.match(line) else (i, "{")
        if not rest.startswith("{") and (end > i or rest == ""):
            yield i + 1, "a body that is not on the one line of its condition has braces"
        if re.match(r"\s*(\} )?else (?!if\b|\{|//)", line) or re.match(r"\s*else$", line):
            yield i + 1, "an if with an else has braces"


def main():
    arguments = sys.argv[1:]
    fix = "--fix" in arguments
    found = False
    for path in (pathlib.Path(name) for name in arguments if name != "--fix"):
        lines = path.read_text().split("\n")
        if fix:
            result, i = [], 0
            while i < len(lines):
                joined = short_body(lines, i)
                result.append(joined or lines[i])
                i += 3 if joined else 1
            if result != lines:
                path.write_text("\n".join(result))
            lines = result
        for number, fault in faults(lines):
            print(f"{path}:{number}: {fault}")
            found = True
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
