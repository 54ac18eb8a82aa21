#!/usr/bin/env python3
"""Count the instructions that the pair loops spend on a directed pair, the work beside them on a particle and the
search for neighbours on a particle and build, and hold them against bounds.

Unlike times, the count is the same on every machine: valgrind executes the AVX2 objects (it knows no AVX-512) of a
small channel, on one thread.

Usage: instructions_per_pair.py PAIR_WORKLOAD
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77  # exit status by which ctest knows a skipped test

# Instructions when they were last looked at: GCC 12.2, -O3, x86-64-v3, lists with the skins of workload_case
# (solver/benchmark.cpp): a thicker skin brings more pairs that do not count. A change that needs more than MARGIN times
# as many has to be worth it; then, or after an improvement, write the new figures. The leapfrog's was: every other step takes
# the continuity sum a second time, and eddying water keeps its volume.
MEASURED = {
    ("2", "plain"): {"gradient_loop": 17.66, "force_loop": 17.92, "particles": 104.1, "search": 396.8},
    ("2", "default"): {"gradient_loop": 21.74, "force_loop": 20.53, "particles": 112.6, "search": 396.8},
    ("3", "plain"): {"gradient_loop": 19.29, "force_loop": 19.41, "particles": 147.0, "search": 2119.3},
    ("3", "default"): {"gradient_loop": 28.57, "force_loop": 29.48, "particles": 176.6, "search": 2119.3},
}
# What is counted: the functions, and per what.
PARTS = {
    "gradient_loop": (("gradient_loop",), "directed pair"),
    "force_loop": (("force_loop",), "directed pair"),
    "particles": (("stress_loop", "advance_loop", "pack_loop"), "particle and step"),
    "search": (("search_neighbours",), "particle and build of the lists"),
}
MARGIN = 1.10
LOOPS = {"gradient_loop": 2}  # how many forms of a function the steps execute, where not one


def instructions(profile):
    """Function -> instructions executed in it and in what it calls, from a file of callgrind."""
    names, counts = {}, {}
    function = None
    with open(profile) as lines:
        for line in lines:
            if match := re.match(r"(c?)fn=\((\d+)\)(?: (.*))?", line):
                if match[3]:
                    names[match[2]] = match[3].strip()
                if not match[1]:
                    function = match[2]
            elif function is not None and (match := re.match(r"(?:[+-]?\d+|\*) (\d+)$", line)):
                # "position cost": of the function itself, or behind "calls=" of the function called.
                counts[function] = counts.get(function, 0) + int(match[1])
    return {names[function]: count for function, count in counts.items()}


def run(*command):
    """Standard output of a command on the AVX2 path."""
    result = subprocess.run(command, capture_output=True, text=True,
                            env={**os.environ, "RIFFLE_INSTRUCTION_SET": "avx2"})
    if result.returncode != 0:
        sys.exit(f"{' '.join(command)} failed:\n{result.stdout}{result.stderr}")
    return result.stdout


def count(program, dimensions, scheme):
    """Part -> instructions per what PARTS says."""
    pairs, particle_steps, particle_builds = map(int, run(program, dimensions, scheme, "count").split())
    per = {"directed pair": pairs, "particle and step": particle_steps,
           "particle and build of the lists": particle_builds}
    with tempfile.TemporaryDirectory() as folder:
        profile = os.path.join(folder, "callgrind.out")
        run("valgrind", "--tool=callgrind", f"--callgrind-out-file={profile}", program, dimensions, scheme)
        of_function = instructions(profile)
    totals = {}
    for part, (functions, unit) in PARTS.items():
        total = 0
        for function in functions:
            found = [n for name, n in of_function.items() if f" riffle::sph::avx2::{function}<" in name.split("(")[0]]
            # The leapfrog's steps take two of the gradient loops in turn.
            if len(found) != LOOPS.get(function, 1):
                sys.exit(f"riffle::sph::avx2::{function}<...> was executed in {len(found)} forms, which is not expected")
            total += sum(found)
        totals[part] = total / per[unit]
    return totals


def main():
    if shutil.which("valgrind") is None:
        print("valgrind is not installed")
        return SKIPPED
    too_many = False
    for (dimensions, scheme), measured in MEASURED.items():
        for part, now in count(sys.argv[1], dimensions, scheme).items():
            bound = MARGIN * measured[part]
            print(f"{dimensions}D {scheme:<8} {part:<14} {now:7.2f} instructions per {PARTS[part][1]}, bound {bound:.2f}")
            too_many = too_many or now > bound
    if too_many:
        print("Find what made them longer (git bisect). If it is worth it, or the compiler is another one, write "
              "the new figures into MEASURED.")
    return 1 if too_many else 0


if __name__ == "__main__":
    sys.exit(main())
