"""What the survival tests share: short cases, their undisturbed results, and what must hold of a folder at any time."""
import argparse
import os
import random
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "end_to_end"))
from riffle_cli import CASE, RIFFLE, SMALL, SOURCE, SPACE_CASE, contents, every, until  # noqa: E402

# Results that tell when the run was, not what it is; the case's text has the settings of the resumes.
APART = ("/case/text", "/case/text@units", "/case/text@long_name")


def in_memory():
    """A folder for the tests' files: in memory where there is such a place, for thousands of flushes."""
    parent = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    return Path(tempfile.mkdtemp(prefix="riffle-survival-", dir=parent))


class Trials:
    """A number of trials with random numbers that can be had again; counts and tells what failed."""

    def __init__(self, description):
        arguments = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
        arguments.add_argument("--trials", type=int, default=12, help="how many (the long tier takes 1000 or 10000)")
        arguments.add_argument("--seed", type=int, default=None)
        arguments.add_argument("--only", type=int, default=None, help="repeat this trial alone")
        self.options = arguments.parse_args()
        self.seed = self.options.seed if self.options.seed is not None else random.SystemRandom().randrange(10**6)
        self.folder = in_memory()
        self.failures = []
        self.counts = {}
        print(f"--trials {self.options.trials} --seed {self.seed}", flush=True)

    def __iter__(self):
        for number in range(self.options.trials):
            if self.options.only in (None, number):
                self.number = number
                self.random = random.Random(f"{self.seed}-{number}")
                yield number

    def count(self, what):
        self.counts[what] = self.counts.get(what, 0) + 1

    def expect(self, condition, message):
        if not condition:
            self.failures.append(f"trial {self.number} (--seed {self.seed} --only {self.number}): {message}")
            print("FAILED", self.failures[-1], flush=True)
        return condition

    def end(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        print(", ".join(f"{number} {what}" for what, number in sorted(self.counts.items())))
        print(f"{len(self.failures)} failures")
        sys.exit(1 if self.failures else 0)


def call(*arguments, timeout=300, environment=None):
    """Run the command to its end."""
    return subprocess.run([RIFFLE, *map(str, arguments)], capture_output=True, text=True, errors="replace",
                          timeout=timeout, env={**os.environ, **(environment or {})}, check=False)


def start(*arguments, environment=None):
    return subprocess.Popen([RIFFLE, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                            env={**os.environ, **(environment or {})})


def differences(first, second):
    """Names of what differs between the results of two folders, up to what tells of the machine."""
    a, b = (contents(folder / "results.h5", APART) for folder in (first, second))
    return sorted(name for name in set(a) | set(b) if a.get(name) != b.get(name))


def space_case(folder):
    path = folder / "space.toml"
    path.write_text(SPACE_CASE)
    return path


def dam_case(folder):
    """A dam break in a tilted tank, from which two of five particles fall over the far wall from 1 s on."""
    path = folder / "dam.toml"
    text = (SOURCE / "cases/violent/dam-break.toml").read_text()
    for old, new in (("slope = 0", "slope = 0.3"), ("600 mm\"\n\n[bed]", "310 mm\"\n\n[bed]"), ("spacing = \"5 mm\"", "spacing = \"20 mm\""), ("1500 Hz", "500 Hz")):
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    path.write_text(text)
    return path


__all__ = ["CASE", "RIFFLE", "SMALL", "SOURCE", "Trials", "call", "contents", "dam_case", "differences", "every", "in_memory", "space_case", "start",
           "until"]
