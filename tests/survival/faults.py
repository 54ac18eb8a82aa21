#!/usr/bin/python3
"""A fault at every call by which Riffle changes files: no crash, a message, and nothing good is lost.

    faults.py [--trials N] [--seed S]

A run, a resume and a report are made again and again, with the fault at the first call of the system that changes a file,
at the second, and so on to the last: the call fails (EIO), it and all writing after it finds a full disk, the process ends
before it, the process ends in the midst of it. `--trials`: how many of all these are tried, drawn at random; 0: all.
The faults come from a library that is loaded before the system's (tests/unit/support/file_faults.cpp); the environment
variable RIFFLE_FILE_FAULTS is its path.
"""
import errno
import os
import shutil
from pathlib import Path

from survival import CASE, SMALL, Trials, call, contents, differences, every, until

LIBRARY = os.environ.get("RIFFLE_FILE_FAULTS", "build/ci/lib/libfile_faults.so")
RUN = [*SMALL, *every(snapshot=0.05, series=0.01)]
FAULTS = {"fail": errno.EIO, "full": errno.ENOSPC, "end": 0, "half": 0}


def with_fault(folder, command, fault, at, in_place):
    """Run a command with a fault; the result, and the number of calls if it came to its end without one."""
    report = folder.parent / "fault.txt"
    report.unlink(missing_ok=True)
    environment = {"LD_PRELOAD": LIBRARY, "RIFFLE_FAULT": fault, "RIFFLE_FAULT_AT": str(at),
                   "RIFFLE_FAULT_ERROR": str(FAULTS.get(fault, 0)), "RIFFLE_FAULT_REPORT": str(report)}
    if in_place:
        environment["RIFFLE_CHANGE_IN_PLACE_FROM"] = "0"
    result = call(*command, environment=environment)
    calls, faulted = report.read_text().split(" ", 1) if report.exists() else ("0", "?")
    return result, int(calls), faulted.strip()


def main():
    trials = Trials(__doc__)
    if not Path(LIBRARY).exists():
        raise SystemExit(f"{LIBRARY}: build the target file_faults, or set RIFFLE_FILE_FAULTS")
    folder = trials.folder / "run"
    half = trials.folder / "half"
    straight = trials.folder / "straight"
    run = ["run", CASE, "-o", folder, "-j", 1, "-q", *RUN, *until(0.2)]
    resume = ["resume", folder, "-j", 1, "-q", *until(0.2)]
    assert call("run", CASE, "-o", straight, "-j", 1, "-q", *RUN, *until(0.2)).returncode == 0
    assert call("run", CASE, "-o", half, "-j", 1, "-q", *RUN, *until(0.1)).returncode == 0

    def prepare(kind):
        shutil.rmtree(folder, ignore_errors=True)
        if kind != "run":
            shutil.copytree(half if kind == "resume" else straight, folder)
        else:
            folder.mkdir()
        return {"run": run, "resume": resume, "report": ["report", folder]}[kind]

    every_fault = []
    for kind in ("run", "resume", "report"):
        for in_place in (False, True):
            if kind == "report" and in_place:
                continue
            result, calls, _ = with_fault(folder, prepare(kind), "none", 0, in_place)
            assert result.returncode == 0, result.stderr
            print(f"{kind}{' in place' if in_place else ''}: {calls} calls")
            every_fault += [(kind, in_place, fault, at) for fault in FAULTS for at in range(calls)]
    trials.random = __import__("random").Random(trials.seed)
    if trials.options.trials:
        every_fault = trials.random.sample(every_fault, min(trials.options.trials, len(every_fault)))
    for trials.number, (kind, in_place, fault, at) in enumerate(every_fault):
        if trials.options.only not in (None, trials.number):
            continue
        command = prepare(kind)
        result, _, faulted = with_fault(folder, command, fault, at, in_place)
        where = f"{kind}{' in place' if in_place else ''}, {fault} at call {at} ({faulted})"
        trials.count(fault)
        if fault in ("end", "half"):
            trials.expect(result.returncode in (0, 9), f"{where}: status {result.returncode}: {result.stderr}")
        else:
            # A lock that cannot be written, a log line that is lost: some faults end nothing.
            trials.expect(result.returncode in (0, 3), f"{where}: status {result.returncode}: {result.stderr}")
            if result.returncode == 3:
                trials.expect(result.stderr.startswith("riffle: error: "), f"{where}: {result.stderr}")
                trials.expect("defect" not in result.stderr, f"{where}: {result.stderr}")
        if kind == "report":
            trials.expect(call("report", folder).returncode == 0, f"{where}: no report afterwards")
            continue
        if not (folder / "checkpoint.h5").exists():
            trials.expect(kind == "run", f"{where}: the checkpoint is gone")
            again = call(*command, "--force")
        else:
            verified = call("verify", folder)
            trials.expect(verified.returncode == 0, f"{where}: {verified.stderr}")
            if not in_place:
                contents(folder / "results.h5")
            again = call(*resume)
        trials.expect(again.returncode == 0, f"{where}: then {again.stderr}")
        if again.returncode == 0:
            found = differences(straight, folder)
            trials.expect(not found, f"{where}: differs: {found}")
        left = [path.name for path in folder.iterdir() if path.suffix in (".new", ".journal")]
        trials.expect(not left, f"{where}: left behind: {left}")
    trials.end()


if __name__ == "__main__":
    main()
