"""Runs Riffle and reads the numbers of its results file."""

import math
import os
import pathlib
import shutil
import subprocess
import sys

import h5py

ROOT = pathlib.Path(__file__).resolve().parents[2]


class RiffleRun:
    """One run of `riffle run`; `values` are the attributes of /summary and some that follow from them."""

    def __init__(self, riffle, case, folder, settings, reuse):
        self.case = case
        self.folder = pathlib.Path(folder)
        self.command = [str(riffle), "run", str(case), "-o", str(folder), "--quiet", "--force"]
        for key, value in settings.items():
            self.command += ["--set", f"{key}={value}"]
        if not (reuse and self._complete()):
            shutil.rmtree(self.folder, ignore_errors=True)
            finished = subprocess.run(self.command, cwd=ROOT, stderr=subprocess.PIPE, text=True)
            if finished.returncode != 0:
                sys.exit(f"{' '.join(self.command)}\nfailed with status {finished.returncode}:\n{finished.stderr}")
        self._read()

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
            self.profiles = {key: data[:] for key, data in file["/profiles"].items()}
        v = self.values
        if "drag_over_gravity" in v:
            v["force_balance_error"] = v["drag_over_gravity"] + v["wall_over_gravity"] - 1.0
        level = v.get("mean_level", math.nan)
        v["level_drift_share"] = v.get("level_drift", math.nan) / level
        v["level_drift_10_s"] = 10.0 * v.get("level_trend", math.nan)


def default_riffle():
    """The binary to run: $RIFFLE, or the one of the release or ci build."""
    candidates = [os.environ.get("RIFFLE", ""), ROOT / "build/release/bin/riffle", ROOT / "build/ci/bin/riffle"]
    for candidate in candidates:
        if candidate and pathlib.Path(candidate).exists():
            return pathlib.Path(candidate)
    sys.exit("no riffle binary: build it (./run-main-job.sh) or name it in the variable RIFFLE")
