"""Run what a page shows: its cases are read, its commands are run in the order of the page, in one working folder,
and what they print is compared with what the page says."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

from blocks import blocks_of
from commands import commands_of, faults_of
from compare import REST, difference, missing_numbers

SOURCE = Path(__file__).resolve().parents[2]
# What pages call by names relative to the root of the sources.
SHARED = ("docs", "python", "tests", "tools", "bench")


def tolerance_of(marker):
    text = marker.get("tolerance")
    return None if text is None else float(text.rstrip("%")) / (100.0 if text.endswith("%") else 1.0)


def steps_of(lines):
    """The commands of a block, each with the range of the lines below it that show what it prints."""
    prompts = any(line.startswith("$ ") for line in lines)
    steps, at = [], 0
    while at < len(lines):
        if not (lines[at].startswith("$ ") or (not prompts and lines[at].strip())):
            at += 1
            continue
        command = lines[at][2:] if prompts else lines[at]
        while command.endswith("\\") and at + 1 < len(lines):
            at += 1
            command = command[:-1] + lines[at].strip()
        first = last = at = at + 1
        while prompts and at < len(lines) and not lines[at].startswith("$ "):
            at += 1
            if lines[at - 1].strip():
                last = at
        steps.append((command, first, last))
    return steps


class PageTest:
    def __init__(self, page, program, tier):
        self.page = page
        self.program = Path(program).resolve()
        self.long = tier == "long"
        self.faults = []
        self.updates = []     # what stands differently: first and last line in the page, the lines printed now
        self.counts = {"commands checked": 0, "cases read": 0, "outputs compared": 0, "skipped": 0, "left to the long tier": 0}
        self.last_output = None

    def fault(self, block, text):
        self.faults.append(f"{block.place}: {text}")

    def run(self):
        text = Path(self.page).read_text()
        with tempfile.TemporaryDirectory(prefix="riffle-page-") as folder:
            self.folder = Path(folder)
            for name in SHARED:
                (self.folder / name).symlink_to(SOURCE / name)
            shutil.copytree(SOURCE / "cases", self.folder / "cases")  # reports of records are written beside them
            programs = self.folder / ".bin"
            programs.mkdir()
            (programs / "riffle").symlink_to(self.program)
            self.environment = dict(os.environ, PATH=f"{programs}:/usr/bin:/bin:{os.environ['PATH']}",
                                    PYTHONPATH=str(SOURCE / "python"), NO_COLOR="1", TERM="dumb")
            self.check_inline(text)
            for block in blocks_of(text, self.page):
                self.test(block)
        return not self.faults

    def check_inline(self, text):
        """Commands within the text, in backticks."""
        for number, line in enumerate(text.split("\n"), 1):
            for command in re.findall(r"`((?:\w+=\w+ )?riffle [a-z][^`]*)`", line):
                self.counts["commands checked"] += 1
                self.faults += [f"{self.page}:{number}: {fault}" for fault in faults_of(command, str(self.program))]

    def shell(self, command, timeout=3600):
        return subprocess.run(["bash", "-c", command], cwd=self.folder, env=self.environment, capture_output=True,
                              text=True, errors="replace", timeout=timeout)

    def test(self, block):
        marker = block.marker
        if block.kind == "code" and block.language not in ("toml", "python", "json", "mermaid", "math", "cpp"):
            for line in commands_of(block):
                self.counts["commands checked"] += 1
                for fault in faults_of(line, str(self.program)):
                    self.fault(block, fault)
        if "skip" in marker:
            self.counts["skipped"] += 1
            return
        if marker.get("tier") == "long" and not self.long:
            self.counts["left to the long tier"] += 1
            return
        if "setup" in marker:
            result = self.shell(marker["setup"])
            if result.returncode != 0:
                self.fault(block, f"its setup failed: {result.stderr.strip()}")
                return
        if block.kind == "code" and block.language == "toml":
            self.read_case(block)
        elif "output" in marker:
            self.compare(block, 0, len(block.lines), self.last_output or [])
        elif "prints" in marker:
            self.compare_with_command(block)
        elif "numbers" in marker:
            self.find_numbers(block)
        elif block.language == "python" and "run" in marker:
            self.run_program(block)
        elif "run" in marker:
            self.run_commands(block)
        elif block.kind == "code" and any(line.startswith("$ ") for line in block.lines):
            self.fault(block, "shows what a command prints, and no marker says how to test it")
        elif marker.keys() - {"setup", "tier", "checks"}:  # the last is for the suites: ../shown_tables.py
            self.fault(block, f"its marker says nothing to do: {marker}")

    def read_case(self, block):
        marker = block.marker
        text = "\n".join(block.lines) + "\n"
        try:
            tomllib.loads(text)
        except tomllib.TOMLDecodeError as error:
            self.fault(block, f"not TOML: {error}")
            return
        base = marker.get("base", "")
        if base:
            text = (self.folder / base).read_text() + "\n" + text
        name = marker.get("file", "case-of-the-page.toml")
        if marker.get("append"):
            text = (self.folder / name).read_text() + "\n" + text
        (self.folder / name).write_text(text)
        result = self.shell(f"riffle new of-the-page.toml --force --from {name}")
        self.counts["cases read"] += 1
        if result.returncode != 0:
            self.fault(block, f"the case is refused: {result.stderr.strip()}")

    def run_program(self, block):
        (self.folder / "program-of-the-page.py").write_text("\n".join(block.lines) + "\n")
        result = self.shell("/usr/bin/python3 program-of-the-page.py")
        self.last_output = result.stdout.split("\n")
        if result.returncode != 0:
            self.fault(block, f"the program fails: {result.stderr.strip()}")

    def run_commands(self, block):
        """Each command with the lines below it, up to the next one."""
        for command, first, last in steps_of(block.lines):
            shown = block.lines[first:last]
            command = re.sub(r"\s{2,}#.*$", "", command)
            result = self.shell(command)
            wanted = int(block.marker.get("status", 0))
            if result.returncode != wanted:
                self.fault(block, f"`{command}` ends with status {result.returncode}, not {wanted}: {result.stderr.strip()}")
            printed = result.stdout.rstrip("\n").split("\n") if result.stdout else []
            if wanted != 0 or (shown and not printed):
                printed = (result.stderr + result.stdout).rstrip("\n").split("\n")
            elif block.marker.get("unordered"):
                printed = (result.stderr.rstrip("\n") + "\n" + result.stdout.rstrip("\n")).split("\n")
            if shown and shown != [REST]:
                self.compare(block, first, last, printed)

    def compare(self, block, first, last, printed):
        """Lines of a block against what was printed."""
        self.counts["outputs compared"] += 1
        shown = block.lines[first:last]
        wrong = difference(shown, printed, tolerance_of(block.marker), block.marker.get("loose"))
        if wrong:
            self.fault(block, f"it is not what is printed:\n{wrong}")
            self.updates.append((block.line + first, block.line + last, block.indent, printed))

    def compare_with_command(self, block):
        result = self.shell(block.marker["prints"])
        if result.returncode != 0:
            self.fault(block, f"`{block.marker['prints']}` fails: {result.stderr.strip()}")
            return
        self.compare(block, 0, len(block.lines), result.stdout.rstrip("\n").split("\n"))

    def find_numbers(self, block):
        result = self.shell(block.marker["numbers"])
        if result.returncode != 0:
            self.fault(block, f"`{block.marker['numbers']}` fails: {result.stderr.strip()}")
            return
        self.counts["outputs compared"] += 1
        missing = missing_numbers("\n".join(block.lines), result.stdout, tolerance_of(block.marker))
        if missing:
            self.fault(block, f"the command does not print {', '.join(missing)}:\n{result.stdout.strip()}")
