"""Runs Riffle and reads the numbers of its results file."""

import hashlib
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys

import h5py
import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]


class RiffleRun:
    """One run of `riffle run`; `values` are the attributes of /summary and some that follow from them. `reuse`: "any" takes
    results of the same case and settings that the folder holds complete, whatever build made them; "same build" those
    of this binary and case file alone, and goes on with a run of theirs that was broken off."""

    def __init__(self, riffle, case, folder, settings, reuse="", threads=0):
        self.case = case
        self.folder = pathlib.Path(folder)
        self.riffle, self.threads = str(riffle), str(threads)
        self.command = [self.riffle, "run", str(case), "-o", str(folder), "--quiet", "--force", "-j", self.threads]
        for key, value in settings.items():
            self.command += ["--set", f"{key}={value}"]
        wanted = json.dumps([str(case), settings], sort_keys=True)
        record = self.folder / "made-from.json"  # so that results of other settings under this name are not taken for these
        origin = self.folder / "made-by.json"
        makers = {name: hashlib.sha256((ROOT / path).read_bytes()).hexdigest() for name, path in (("binary", riffle), ("case", case))}
        same = _text(record) == wanted and _text(origin) == json.dumps(makers)
        taken = same if reuse == "same build" else reuse == "any" and _text(record) in (None, wanted)
        if not (taken and self._complete()):
            if not (same and reuse == "same build" and self._goes_on()):
                shutil.rmtree(self.folder, ignore_errors=True)
                self.folder.mkdir(parents=True)
                record.write_text(wanted)
                origin.write_text(json.dumps(makers))
                finished = subprocess.run(self.command, cwd=ROOT, stderr=subprocess.PIPE, text=True)
                if finished.returncode != 0:
                    sys.exit(f"{' '.join(self.command)}\nfailed with status {finished.returncode}:\n{finished.stderr}")
        self._read()

    def _goes_on(self):
        """Whether a run that was broken off came to its end from its checkpoint."""
        if not (self.folder / "checkpoint.h5").exists():
            return False
        return subprocess.run([self.riffle, "resume", str(self.folder), "--quiet", "-j", self.threads], cwd=ROOT).returncode == 0

    def _complete(self):
        try:
            with h5py.File(self.folder / "results.h5", "r") as file:
                return int(file.attrs["complete"]) == 1
        except OSError:
            return False

    def _read(self):
        with h5py.File(self.folder / "results.h5", "r") as file:
            text = lambda value: value.decode() if isinstance(value, bytes) else value
            self.values = {key: text(value) for key, value in file["/summary"].attrs.items()}
            self.column = dict(file["/column"].attrs.items()) if "/column" in file else {}
            self.series = {key: data[:] for key, data in file["/time_series"].items()}
            self.profiles = {key: data[:] for key, data in file["/profiles"].items()} if "/profiles" in file else {}
            snapshots = [file["/snapshots"][name] for name in sorted(file["/snapshots"])]
            self.snapshot_time = numpy.array([float(group.attrs["time"]) for group in snapshots])
            self.mean_height = numpy.array([numpy.mean(group["position"][:, 2], dtype=float) for group in snapshots])
        v = self.values
        if "drag_over_gravity" in v:
            v["force_balance_error"] = v["drag_over_gravity"] + v["wall_over_gravity"] - 1.0
        self._measure_depth()

    def _measure_depth(self):
        """Drift of the depth, from twice the mean height of the particles in the snapshots.

        The mean height tells the volume of the water; the detected surface also sees how the top row is arranged."""
        v = self.values
        depth = 2.0 * self.mean_height
        inside = self.snapshot_time >= v.get("window_start", 0.0)
        if inside.sum() > 2:
            v["level_drift_10_s"] = 10.0 * numpy.polyfit(self.snapshot_time[inside], depth[inside], 1)[0]
        early, late = self.snapshot_time <= 1.01, self.snapshot_time >= self.snapshot_time[-1] - 1.01
        v["level_drift_share"] = (depth[late].mean() - depth[early].mean()) / v["total_depth"]


def _text(path):
    return path.read_text() if path.exists() else None


def add_reuse_options(parser):
    """The options that say which results of --keep are taken as they are: `reuse` of RiffleRun."""
    choice = parser.add_mutually_exclusive_group()
    choice.add_argument("--reuse", action="store_const", const="any", default="", help="take complete results from --keep, whatever build made them")
    choice.add_argument("--continue", action="store_const", const="same build", dest="reuse",
                        help="take those that this very binary made from this case, and go on with its runs that were broken off")


def half_width(values, name):
    """Text of a 95 % interval, which a mean of fewer than ten independent samples does not have."""
    width = values.get(f"{name}_half_width")
    return "few samples" if width is None else f"{width:.1g}"


def default_riffle():
    """The binary to run: $RIFFLE, or the one of the release or ci build."""
    candidates = [os.environ.get("RIFFLE", ""), ROOT / "build/release/bin/riffle", ROOT / "build/ci/bin/riffle"]
    for candidate in candidates:
        if candidate and pathlib.Path(candidate).exists():
            return pathlib.Path(candidate)
    sys.exit("no riffle binary: build it (./run-main-job.sh) or name it in the variable RIFFLE")
