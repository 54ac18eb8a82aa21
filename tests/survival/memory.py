#!/usr/bin/python3
"""The memory of whole runs: its peak against the forecast of `riffle check`, and bytes a particle.

    memory.py [--large]

Short runs in two and three dimensions with every kind of record due several times (mean field, maps, snapshots,
instruments, checkpoints), small and large. The peak is that of the process (VmHWM). Bars: forecast within 10 %; with
`--large` a million particles in three dimensions in 400 bytes each.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "end_to_end"))
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import known_misses  # noqa: E402
from riffle_cli import RIFFLE, SOURCE  # noqa: E402

FORECAST_BAR = 0.10
BYTES_BAR = 400

PLANE = SOURCE / "cases/rough-bed-2d/condition-2.toml"
SPACE = SOURCE / "cases/rough-bed-3d/condition-2.toml"
ALL_FIELDS = 'output.snapshot_fields="velocity pressure density eddy_viscosity"'


def due_often(seconds, *of_space):
    """Every record at the start, once on the way and in the end of so many seconds.

    More often, what waits to be written would be much beside the particles, and would hang on the speed of the machine: the first
    write comes after two seconds."""
    names = ("snapshot", "series", "profile", "surface", *of_space)
    return [f'run.until="{seconds} s"', ALL_FIELDS, *(f"output.{name}_interval={seconds / 1.5:.4g}" for name in names)]


SPACE_RECORDS = ("mean_field", "surface_map")
CASES = {
    "2D, 500 particles": (PLANE, ["numerics.spacing=2.5mm", "channel.length=0.06", *due_often(0.2)]),
    "2D, 60 thousand": (PLANE, ["numerics.spacing=0.5mm", "channel.length=0.27", *due_often(0.002)]),
    "3D, 11 thousand": (SPACE, ["numerics.spacing=5mm", "channel.width=0.2", *due_often(0.01, *SPACE_RECORDS)]),
    "3D, 135 thousand": (SPACE, ["numerics.spacing=3.2mm", *due_often(0.004, *SPACE_RECORDS)]),
}
LARGE = {
    "2D, a million": (PLANE, ["numerics.spacing=0.25mm", "channel.length=1.12", *due_often(0.0006)]),
    "3D, a million": (SPACE, ["numerics.spacing=1.65mm", *due_often(0.002, *SPACE_RECORDS)]),
}


def options(settings):
    return [part for setting in settings for part in ("--set", setting)]


def peak_of(command):
    """Largest resident memory of a command, bytes."""
    process = subprocess.Popen(list(map(str, command)), stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))}: status {process.returncode}")
    return 1024 * used.ru_maxrss


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--large", action="store_true", help="a million particles too: some minutes, 1 GB")
    arguments.add_argument("--threads", type=int, default=1)
    chosen = arguments.parse_args()
    missed = []
    print(f"{'run':<20} {'particles':>9} {'peak MB':>8} {'forecast MB':>11} {'forecast/peak':>13} {'bytes each':>10}")
    with tempfile.TemporaryDirectory(prefix="riffle-memory-") as folder:
        for name, (case, settings) in {**CASES, **(LARGE if chosen.large else {})}.items():
            common = [case, *options(settings), "-j", chosen.threads]
            check = subprocess.run([RIFFLE, "check", *map(str, common), "--json"], capture_output=True, text=True, check=True)
            forecast = json.loads(check.stdout)
            particles = forecast["particles"]
            peak = peak_of([RIFFLE, "run", *common, "-o", Path(folder) / name.replace(" ", "-"), "-q"])
            ratio = forecast["memory_bytes"] / peak
            print(f"{name:<20} {particles:>9} {peak / 1e6:>8.1f} {forecast['memory_bytes'] / 1e6:>11.1f} {ratio:>13.3f} "
                  f"{peak / particles:>10.0f}", flush=True)
            if abs(ratio - 1) > FORECAST_BAR:
                missed.append(f"{name}: the forecast is {100 * (ratio - 1):+.1f} % off")
            if name == "3D, a million":
                key = ("survival", "memory.py --large", name, "bytes a particle")
                verdict, text = known_misses.judge(known_misses.read(), key, peak / particles, BYTES_BAR)
                if verdict == "known":
                    print("KNOWN MISS:", text)
                elif verdict == "missed":
                    missed.append(text)
    print("\n".join(missed) or "all within their bars")
    return len(missed)


if __name__ == "__main__":
    sys.exit(min(main(), 1))
