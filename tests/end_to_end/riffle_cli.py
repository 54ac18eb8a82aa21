"""What the end-to-end tests share: calling the command line, short cases, comparing results files bit by bit."""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
RIFFLE = os.environ.get("RIFFLE", str(SOURCE / "build/ci/bin/riffle"))
CASE = SOURCE / "cases/rough-bed-2d/condition-2.toml"
SKIPPED = 77  # exit status by which ctest knows a skipped test
# The browser of the tests that draw pages, as in tools/browser.mjs; None where there is none.
BROWSER = next((path for path in (os.environ.get("CHROMIUM"), "/usr/bin/chromium-headless-shell", "/usr/bin/chromium")
                if path and Path(path).exists()), None)

# Flow condition 2 with some 500 particles: a simulated second takes a fraction of one.
SMALL = ["--set", "numerics.spacing=2.5mm", "--set", "channel.length=0.06"]

# The same water in three dimensions, two lattice periods of 25 mm spheres across, some 1400 particles.
SPACE_CASE = """
title = "condition 2, a cell of the bed"
[channel]
dimensions = 3
slope = 0.004
depth = "50 mm"
length = "50 mm"
width = "43.3013 mm"
[bed]
sphere_diameter = "25 mm"
roughness_height = "10 mm"
datum_below_crest = "4 mm"
[turbulence]
closure = "czernuszenko-rylov"
[numerics]
spacing = "5 mm"
[start]
jitter = 0.1
[run]
until = "1 s"
[output]
mean_field_interval = "0.15 s"
"""

# Results that tell about the machine and the hour, not about the flow.
OF_THE_MACHINE = {
    "/@run", "/@created", "/@unused_bytes", "/summary@wall_clock_seconds", "/summary@particle_updates_per_second",
    "/summary@threads",
}


# An instrument of each kind, at home in a channel of SMALL; at frequencies that no other record has.
PROBES = """
[[probe]]
name = "adv"
kind = "velocity"
sampling_frequency = "77 Hz"
x = "30 mm"
z = ["5 mm", "20 mm", "40 mm", "60 mm"]
sampling_length = "4 mm"
[[probe]]
name = "gauges"
kind = "wave"
sampling_frequency = "90 Hz"
x = [0, "28 mm"]
[[probe]]
name = "line"
kind = "surface_line"
sampling_frequency = "30 Hz"
[[probe]]
name = "piv"
kind = "grid"
sampling_frequency = "55 Hz"
averaging_time = "0.07 s"
start = "0.05 s"
[[probe]]
name = "sections"
kind = "flow_rate"
sampling_frequency = "40 Hz"
x = [0, 0.01, 0.02, 0.03, 0.04, 0.05]
[[probe]]
name = "transducers"
kind = "pressure"
sampling_frequency = "85 Hz"
x = "30 mm"
z = [0, "20 mm"]
[[probe]]
name = "forces"
kind = "force"
sampling_frequency = "50 Hz"
"""


SPACE_PROBES = (PROBES.replace('x = "30 mm"', 'x = "30 mm"\ny = "12 mm"')
                .replace('x = [0, "28 mm"]', 'x = [0, "28 mm"]\ny = ["10 mm", "20 mm"]')
                .replace('"surface_line"', '"surface_line"\ny = "15 mm"')
                .replace('"grid"', '"grid"\ny = "40 mm"').replace(", 0.05]", "]"))


def text(value):
    """A text that h5py gives as bytes."""
    return value.decode() if isinstance(value, bytes) else value


def until(seconds):
    return ["--set", f'run.until="{seconds} s"']


def every(**intervals):
    """every(snapshot=0.1): the option that sets output.snapshot_interval."""
    return [part for name, value in intervals.items() for part in ("--set", f"output.{name}_interval={value}")]


def riffle(*arguments, timeout=240, **options):
    """Run the command to its end; its output has no terminal."""
    return subprocess.run([RIFFLE, *map(str, arguments)], capture_output=True, text=True, errors="replace",
                          timeout=timeout, **options)


def start(*arguments):
    """Start the command and leave it running."""
    return subprocess.Popen([RIFFLE, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def wait_for(condition, what, seconds=60):
    deadline = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f"waited {seconds} s in vain for {what}")
        time.sleep(0.002)


def contents(path, leave_out=()):
    """All datasets and attributes of a results file: path -> (type, shape, bytes)."""
    import h5py
    import numpy

    found = {}

    def note(name, value):
        if name not in OF_THE_MACHINE and name not in leave_out:
            array = numpy.asarray(value)
            data = [str(item) for item in array.ravel()] if array.dtype.hasobject else array.tobytes()
            found[name] = (str(array.dtype), array.shape, data)

    def visit(name, item):
        for key, value in item.attrs.items():
            note(f"{name}@{key}", value)
        if isinstance(item, h5py.Dataset):
            note(name, item[()])

    with h5py.File(path, "r") as file:
        visit("/", file)
        file.visititems(lambda name, item: visit("/" + name, item))
    return found


def kept_files(folder):
    """Contents of all files of a folder, by path, but for the locks, in which the last process that asked stands."""
    return {path: path.read_bytes() for path in sorted(Path(folder).rglob("*"))
            if path.is_file() and path.name not in (".run.lock", ".sweep.lock")}


class CommandLineTest(unittest.TestCase):
    """A test with a folder of its own, self.folder."""

    def need_browser(self, driver=True):
        """Skip where nothing can draw a page; driver: the test steers the browser from node."""
        if not BROWSER:
            self.skipTest("no browser (package chromium-headless-shell)")
        if driver and not shutil.which("node"):
            self.skipTest("no node (package nodejs)")
        if driver and not (SOURCE / "web/node_modules/playwright-core").exists():
            self.skipTest("no playwright-core: npm ci --prefix web")

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="riffle-test-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def succeed(self, *arguments, **options):
        result = riffle(*arguments, **options)
        self.assertEqual(result.returncode, 0, f"riffle {' '.join(map(str, arguments))}\n{result.stderr}")
        self.assertNotIn("\x1b", result.stdout + result.stderr, "escape codes outside a terminal")
        return result

    def fail_with(self, status, *arguments, says=(), **options):
        """Run a command that must fail with this exit status and an error message with these words."""
        result = riffle(*arguments, **options)
        command = f"riffle {' '.join(map(str, arguments))}"
        self.assertEqual(result.returncode, status, f"{command}\n{result.stderr}")
        self.assertRegex(result.stderr, r"(?m)^riffle: error: ", command)
        self.assertNotIn("\x1b", result.stderr)
        self.assertNotIn("unexpected fault", result.stderr)
        for words in says:
            self.assertIn(words, result.stderr, command)
        return result

    def case_with_probes(self):
        """Flow condition 2 with an instrument of each kind beside the standard ones."""
        path = self.folder / "probes.toml"
        path.write_text(CASE.read_text() + PROBES)
        return path

    def space_case(self):
        path = self.folder / "space.toml"
        path.write_text(SPACE_CASE)
        return path

    def space_case_with_probes(self):
        """The cell of the bed with an instrument of each kind, off the centreline where they can be."""
        path = self.folder / "space-probes.toml"
        path.write_text(SPACE_CASE + SPACE_PROBES)
        return path

    def run_space(self, name, seconds, *options, threads=1, case=None):
        """A short run in three dimensions in self.folder/name; its folder."""
        folder = self.folder / name
        self.succeed("run", case or self.space_case(), "-o", folder, "-j", threads, "-q", *until(seconds), *options)
        return folder

    def run_small(self, name, seconds, *options, threads=1, case=CASE):
        """A short run in self.folder/name; its folder."""
        folder = self.folder / name
        self.succeed("run", case, "-o", folder, "-j", threads, "-q", *SMALL, *until(seconds), *options)
        return folder

    def assert_same_results(self, first, second, leave_out=()):
        """The results of two folders agree in every bit, up to what tells about the machine."""
        a, b = (contents(folder / "results.h5", leave_out) for folder in (first, second))
        self.assertEqual(sorted(a), sorted(b), f"{first} and {second} hold different data")
        different = [name for name in a if a[name] != b[name]]
        self.assertEqual(different, [], f"{first} and {second} differ")

    def assert_readable(self, folder):
        """The results file is whole: every byte can be read, and the series have one length."""
        data = contents(folder / "results.h5")
        lengths = {shape for name, (_, shape, _) in data.items() if re.fullmatch(r"/time_series/\w+", name)}
        self.assertEqual(len(lengths), 1, "time series of different lengths")


def main():
    """Run the tests of the calling script; exit with 77 when every one was skipped."""
    program = unittest.main(exit=False, verbosity=2)
    result = program.result
    if result.wasSuccessful() and result.testsRun > 0 and len(result.skipped) == result.testsRun:
        sys.exit(SKIPPED)
    sys.exit(0 if result.wasSuccessful() else 1)
