#!/usr/bin/python3
"""Time and memory that `riffle analyse` takes for a results file of about a gigabyte.

    large_results.py RESULTS.h5 --riffle build/release/bin/riffle [--keep FILE]

Takes a finished run's results, replaces its surface by 100 thousand records over 1000 places (800 MB), adds a velocity
probe of 32 points with 400 thousand samples and 100 snapshots of 20 thousand particles, all of random numbers with the
run's own times, and analyses that. Prints the size, the wall-clock and processor time and the largest resident memory; fails
beyond 60 s or 2 GB.
"""
import argparse
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time

import h5py
import numpy

TIME_BAR = 60.0
MEMORY_BAR = 2e9


def enlarge(path):
    random = numpy.random.default_rng(1)
    with h5py.File(path, "r+") as file:
        start, end = (float(file["profiles"].attrs[key]) for key in ("window_start", "window_end"))
        length = float(file["surface/x"][-1] + file["surface/x"][0])
        records, places, block = 100_000, 1000, 2000
        for name in ("x", "time", "elevation"):
            del file[f"surface/{name}"]
        x = (numpy.arange(places) + 0.5) * length / places
        t = numpy.linspace(start, end, records)
        file["surface/x"], file["surface/time"] = x, t
        elevation = file.create_dataset("surface/elevation", (records, places), dtype="f8", chunks=(64, places))
        waves = [(2 * numpy.pi * n / length, random.uniform(0, 2 * numpy.pi)) for n in range(1, 9)]
        for i in range(0, records, block):
            now = t[i:i + block, None]
            waved = sum(1e-4 * numpy.cos(k * (x - 0.3 * now) + phase) for k, phase in waves)
            elevation[i:i + block] = 0.06 + waved + 1e-5 * random.standard_normal(waved.shape)

        samples, points = 400_000, 32
        probe = file.create_group("probes/large")
        probe.attrs.update(kind="velocity", sampling_frequency=samples / (end - start), standard=0)
        probe["x"], probe["z"] = numpy.full(points, length / 2), numpy.linspace(0.01, 0.05, points)
        probe["time"] = numpy.linspace(start, end, samples)
        for name, mean in (("velocity", 0.3), ("vertical_velocity", 0.0)):
            values = mean + 0.02 * random.standard_normal((samples, points))
            probe.create_dataset(name, data=values.astype("f4"), chunks=(4096, points))

        particles = 20_000
        for index in range(10_000, 10_100):
            snapshot = file.create_group(f"snapshots/{index}")
            snapshot.attrs["time"] = float(index)
            for name, width in (("position", 3), ("velocity", 3), ("pressure", 1), ("density", 1)):
                shape = (particles, width) if width > 1 else particles
                snapshot[name] = random.standard_normal(shape).astype("f4")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("results", type=pathlib.Path)
    arguments.add_argument("--riffle", default="build/release/bin/riffle")
    arguments.add_argument("--keep", type=pathlib.Path, help="keep the large file here")
    options = arguments.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        large = options.keep or pathlib.Path(folder) / "results.h5"
        shutil.copy(options.results, large)
        enlarge(large)
        subprocess.run([options.riffle, "verify", "--accept", large], check=True, stdout=subprocess.DEVNULL)
        begin = time.monotonic()
        subprocess.run([options.riffle, "analyse", large], check=True, stdout=subprocess.DEVNULL)
        seconds = time.monotonic() - begin
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        memory = 1024.0 * used.ru_maxrss
        print(f"{large.stat().st_size / 1e6:.0f} MB analysed in {seconds:.1f} s (bar {TIME_BAR:.0f}; "
              f"{used.ru_utime + used.ru_stime:.1f} s of processors) with {memory / 1e6:.0f} MB (bar {MEMORY_BAR / 1e6:.0f})")
        return int(seconds > TIME_BAR or memory > MEMORY_BAR)


if __name__ == "__main__":
    sys.exit(main())
