#!/usr/bin/python3
"""Damaged results and checkpoints: each one is refused, with its name, and no command crashes or hangs.

    mutations.py [--trials N] [--seed S]

A mutation is one to four flipped bits, some bytes overwritten, a stretch zeroed, cut out, doubled, or taken from elsewhere
in the file, or the file cut short. `riffle verify` must refuse every one; resume, report, analyse and a start from the
results (one of them, drawn at random, for each fiftieth) must refuse it too and leave the folder as it is. Set RIFFLE to a
build with sanitizers to look for faults in memory.
"""
import hashlib
import shutil

from survival import CASE, SMALL, Trials, call, every, until

AT_ONCE = 50


def mutate(data, random):
    """Another content, and what was done."""
    data = bytearray(data)
    kind = random.choice(["bits", "bytes", "zeros", "cut", "doubled", "moved", "truncated"])
    at = random.randrange(len(data))
    length = min(random.choice([1, 8, 64, 512, 4096]), len(data) - at)
    if kind == "bits":
        for _ in range(random.randint(1, 4)):
            data[random.randrange(len(data))] ^= 1 << random.randrange(8)
    elif kind == "bytes":
        data[at:at + length] = random.randbytes(length)
    elif kind == "zeros":
        data[at:at + length] = bytes(length)
    elif kind == "cut":
        del data[at:at + length]
    elif kind == "doubled":
        data[at:at] = data[at:at + length]
    elif kind == "moved":
        other = random.randrange(len(data) - length + 1)
        data[at:at + length] = data[other:other + length]
    else:
        del data[at:]
    return bytes(data), kind


def state(folder):
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.iterdir()
            if path.name not in ("run.log", ".run.lock")}


def main():
    trials = Trials(__doc__)
    whole = trials.folder / "whole"
    result = call("run", CASE, "-o", whole, "-j", 1, "-q", *SMALL, *until(0.4), *every(snapshot=0.1))
    assert result.returncode == 0, result.stderr
    originals = {name: (whole / name).read_bytes() for name in ("results.h5", "checkpoint.h5")}
    waiting = []

    def verify_all():
        result = call("verify", *[path for path, _ in waiting], timeout=600)
        trials.expect(result.returncode == 3, f"riffle verify: {result.returncode} {result.stderr[-500:]}")
        for path, what in waiting:
            trials.expect(f"riffle: error: {path}: " in result.stderr, f"{what} passes: {path}")
            path.unlink()
        waiting.clear()

    for number in trials:
        name = list(originals)[number % len(originals)]
        data, kind = mutate(originals[name], trials.random)
        if data == originals[name]:
            continue
        if name == "results.h5" and data.startswith(originals[name]):
            # All of the content is there: a change in place that is killed leaves a tail like this.
            path = trials.folder / "results-longer.h5"
            path.write_bytes(data)
            result = call("verify", path)
            trials.expect(result.returncode == 0 and "behind the end" in result.stdout, f"bytes behind the end: {result.stdout} {result.stderr}")
            continue
        trials.count(f"{name} {kind}")
        path = trials.folder / f"{name.split('.')[0]}-{number}.h5"
        path.write_bytes(data)
        waiting.append((path, kind))
        if number % 50 == 0:
            folder = trials.folder / "damaged"
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(whole, folder)
            (folder / name).write_bytes(data)
            before = state(folder)
            commands = {"resume": ["resume", folder, "-q", *until(0.6)], "verify": ["verify", folder]}
            if name == "results.h5":
                commands |= {"report": ["report", folder], "analyse": ["analyse", folder],
                             "start": ["run", CASE, "-o", trials.folder / "next", "-q", *SMALL, *until(0.01), "--force",
                                       "--set", "start.kind=results", "--set", f'start.file="{folder / name}"']}
            verb = trials.random.choice(list(commands))
            result = call(*commands[verb], timeout=120)
            # What a start does not read may be damaged.
            allowed = (3, 2, 0) if verb == "start" else (3,)
            trials.expect(result.returncode in allowed, f"{verb} after {kind}: {result.returncode} {result.stderr[-500:]}")
            trials.expect(state(folder) == before, f"{verb} after {kind} changed the folder")
            trials.count(f"refused by {verb}")
        if len(waiting) == AT_ONCE:
            verify_all()
    if waiting:
        verify_all()
    trials.end()


if __name__ == "__main__":
    main()
