"""Code blocks, tables and paragraphs of a Markdown page, each with the marker that stands before it.

A marker is a comment that pages do not show:

    <!-- test: run tolerance=2% loose="left" -->

Words without = are flags. It belongs to the next block: a fenced or indented one, a table, or a paragraph."""
import re
import shlex
from dataclasses import dataclass, field

MARKER = re.compile(r"^\s*<!-- test:(?P<text>.*?)-->\s*$")
FENCE = re.compile(r"^(?P<indent>\s*)(?P<ticks>```+)(?P<language>\w*)\s*$")

KNOWN = {
    # what a block is
    "run": "commands behind `$ `, each with what it prints below; or plain commands, which must succeed",
    "case": "a case file, which must be right (every toml block is one without saying so)",
    "file": "the block is written to this file of the working folder",
    "base": "what stands before the block in that case: a file of the sources, or of the working folder",
    "append": "the block is added to the end of the file named by file=",
    "output": "what the block before, a program, prints",
    "prints": "command whose output the block is, line by line",
    "numbers": "command among whose numbers each number of the block is",
    "checks": "of a table: the checks of tests/verification/verify.py whose norms its rows show, one for each first cell (or one for all, - for none)",
    "skip": "not tested, for this reason",
    # how
    "tier": "quick (the default) or long",
    "tolerance": "largest departure of a number, relative: 2%; without it numbers are the same to the last digit shown",
    "loose": "lines that this regular expression finds: words alone are compared",
    "setup": "shell command before the block, not shown on the page",
    "status": "exit status of its commands, if not 0",
    "unordered": "lines of standard error stand before or behind those of standard output",
}


class MarkerError(Exception):
    pass


@dataclass
class Block:
    page: str
    line: int           # of its first line of text, from 1
    kind: str           # "code", "table" or "text"
    language: str       # of a fence; "" of an indented block
    lines: list
    marker: dict = field(default_factory=dict)
    indent: str = ""    # that each line has in the page

    @property
    def place(self):
        return f"{self.page}:{self.line}"


def marker_of(text, place):
    marker = {}
    for word in shlex.split(text):
        name, equals, value = word.partition("=")
        if name not in KNOWN:
            raise MarkerError(f"{place}: unknown word `{name}` in a marker; known are {', '.join(KNOWN)}")
        marker[name] = value if equals else True
    return marker


def is_indented(line):
    return line.startswith("    ") and line.strip() != ""


def blocks_of(text, page):
    """All blocks of a page in their order; a marker without a block is an error."""
    lines = text.split("\n")
    found, marker, marker_line, in_list = [], {}, 0, False
    i = 0

    def add(kind, language, first, last, indent=""):
        nonlocal marker
        body = [line[len(indent):] if line.startswith(indent) else line.lstrip() for line in lines[first:last]]
        found.append(Block(page, first + 1, kind, language, body, marker, indent))
        marker = {}

    while i < len(lines):
        line = lines[i]
        comment = MARKER.match(line)
        fence = FENCE.match(line)
        if comment:
            if marker:
                raise MarkerError(f"{page}:{marker_line}: a marker without a block")
            marker, marker_line = marker_of(comment["text"], f"{page}:{i + 1}"), i + 1
            i += 1
        elif fence:
            last = i + 1
            while last < len(lines) and not (lines[last].strip() == fence["ticks"]):
                last += 1
            add("code", fence["language"] or "text", i + 1, last, fence["indent"])
            i = last + 1
        elif is_indented(line) and not in_list and (i == 0 or lines[i - 1].strip() == "" or MARKER.match(lines[i - 1])):
            last = i
            while last < len(lines) and (is_indented(lines[last]) or (
                    lines[last].strip() == "" and last + 1 < len(lines) and is_indented(lines[last + 1]))):
                last += 1
            add("code", "", i, last, "    ")
            i = last
        elif line.strip() == "":
            i += 1
        else:
            last = i
            while last < len(lines) and lines[last].strip() and not MARKER.match(lines[last]) \
                    and not FENCE.match(lines[last]):
                last += 1
            in_list = bool(re.match(r"\s*([-*]|\d+\.)\s", line)) or (in_list and line.startswith(" "))
            table = line.lstrip().startswith("|")
            if marker or table:
                add("table" if table else "text", "", i, last)
            i = last
        if in_list and i < len(lines) and lines[i].strip() and not lines[i].startswith(" "):
            in_list = False
    if marker:
        raise MarkerError(f"{page}:{marker_line}: a marker without a block")
    return found
