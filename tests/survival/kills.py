#!/usr/bin/python3
"""Runs that are killed at random moments, again and again, and resumed: they end as the run that was left alone.

    kills.py [--trials N] [--seed S] [--only TRIAL]

Each trial is a chain of kills (SIGKILL) of one kind:

- run and resume, in two or three dimensions, with water that leaves the domain or enters and leaves through open ends, results changed in
  place or written anew;
- resume --from checkpoint-previous.h5, killed as well;
- a sweep, of whose runs each must end as it does alone;
- while reports and verifications of the folder are made and killed too.

After each kill the results can be read to the last byte, every file that `riffle verify` looks at is whole, and plain
`riffle resume` goes on; at the end all results agree with the undisturbed run to the bit.
"""
import shutil
import time

from survival import CASE, SMALL, SOURCE, Trials, call, contents, dam_case, differences, every, space_case, start, until

SECONDS = 3
OFTEN = every(checkpoint=0.01, snapshot=0.25, series=0.01)
SPACE_SECONDS = 1.2
LOSSES_SECONDS = 1.5
STREAM_SECONDS = 0.6
STREAM = SOURCE / "cases/open-ends/uniform.toml"
MOST_KILLS = 12
IN_PLACE = {"RIFFLE_CHANGE_IN_PLACE_FROM": "0"}


class Kind:
    """A way to run: the command, and the folder of its undisturbed results."""

    def __init__(self, trials, name, command, environment=None):
        self.command, self.environment = command, environment
        self.straight = trials.folder / f"straight-{name}"
        result = call(*command(self.straight))
        if result.returncode != 0:
            raise SystemExit(result.stderr)


def check(trials, folder):
    """What must hold at any time once there is a checkpoint."""
    verified = call("verify", folder)
    trials.expect(verified.returncode == 0, f"riffle verify: {verified.stderr}")
    try:
        contents(folder / "results.h5")
    except Exception as error:  # whatever h5py makes of it
        # In place, a kill in the midst of the change leaves a file that Riffle reads and completes, and others do not.
        trials.expect((folder / "results.h5.journal").exists(), f"h5py: {error}")
        trials.count("kills in the midst of a change in place")


def kill(process):
    process.kill()
    _, errors = process.communicate()
    return process.returncode, errors


def chain(trials, kind, folder):
    """Kill the run and its resumes until one comes to its end."""
    first = kind.command(folder)
    process = start(*first, environment=kind.environment)
    for number in range(MOST_KILLS):
        time.sleep(trials.random.expovariate(1 / 0.15))
        report = None
        if (folder / "checkpoint.h5").exists() and trials.random.random() < 0.2:
            report = start("report", folder, "-o", trials.folder / "report.html")
            time.sleep(trials.random.uniform(0, 0.1))
        status, errors = kill(process)
        if report:
            trials.expect(report.wait(timeout=120) in (0, 3), f"report beside the run: {report.stderr.read()}")
            report.stderr.close()
            trials.count("reports beside a run")
        if status == 0:
            return
        if not trials.expect(status == -9, f"ended by itself with {status}: {errors}"):
            return
        trials.count("kills")
        if not (folder / "checkpoint.h5").exists():
            process = start(*first, "--force", environment=kind.environment)
            continue
        check(trials, folder)
        more = ["resume", folder, "-j", 1 + number % 2, "-q"]
        if (folder / "checkpoint-previous.h5").exists() and trials.random.random() < 0.3:
            more += ["--from", "checkpoint-previous.h5"]
            trials.count("resumes from the previous checkpoint")
        process = start(*more, environment=kind.environment)
    _, errors = process.communicate(timeout=300)
    trials.expect(process.returncode == 0, f"the last resume: {errors}")


def sweep_trial(trials, folder):
    """Kill a sweep, and take it up again; each run is as the one alone."""
    command = ["sweep", CASE, "-o", folder, "-q", "-j", 1, "--jobs", 2, *SMALL, *until(SECONDS / 2), *OFTEN,
               "--vary", "numerics.courant_number=0.2,0.25"]
    for _ in range(4):
        process = start(*command)
        time.sleep(trials.random.uniform(0.05, 0.6))
        status, errors = kill(process)
        if status == 0:
            break
        trials.count("kills of a sweep")
        # Its runs write their checkpoints after it; until then the folder is theirs.
        time.sleep(0.3)
        for run in folder.glob("*/checkpoint.h5"):
            check(trials, run.parent)
    result = call(*command)
    for _ in range(20):
        if "another sweep works" not in result.stderr:
            break
        time.sleep(0.2)
        result = call(*command)
    trials.expect(result.returncode == 0, f"the sweep: {result.stderr}")
    for run in sorted(path.parent for path in folder.glob("*/results.h5")):
        number = "0.2" if "0.2" in run.name and "0.25" not in run.name else "0.25"
        alone = trials.folder / f"alone-{number}"
        if not alone.exists():
            call("run", CASE, "-o", alone, "-q", "-j", 1, *SMALL, *until(SECONDS / 2), *OFTEN, "--set",
                 f"numerics.courant_number={number}")
        trials.expect(not differences(alone, run), f"{run.name} differs: {differences(alone, run)}")


def main():
    trials = Trials(__doc__)
    case, dam = space_case(trials.folder), dam_case(trials.folder)

    def plane(folder):
        return ["run", CASE, "-o", folder, "-j", 1, "-q", *SMALL, *until(SECONDS), *OFTEN]

    def space(folder):
        return ["run", case, "-o", folder, "-j", 1, "-q", *until(SPACE_SECONDS), *OFTEN]

    def losses(folder):
        return ["run", dam, "-o", folder, "-j", 1, "-q", *until(LOSSES_SECONDS), *OFTEN]

    def stream(folder):
        return ["run", STREAM, "-o", folder, "-j", 1, "-q", "--set", "numerics.spacing=3mm", "--set", 'run.average_from="0.3 s"', *until(STREAM_SECONDS), *OFTEN]

    kinds = [Kind(trials, "plane", plane), Kind(trials, "stream", stream), Kind(trials, "plane-in-place", plane, IN_PLACE), Kind(trials, "losses", losses),
             Kind(trials, "space-in-place", space, IN_PLACE), Kind(trials, "losses-in-place", losses, IN_PLACE)]
    for number in trials:
        folder = trials.folder / f"trial-{number}"
        if number % 10 == 9:
            sweep_trial(trials, folder)
        else:
            kind = kinds[number % len(kinds)]
            chain(trials, kind, folder)
            trials.expect(not differences(kind.straight, folder), f"differs: {differences(kind.straight, folder)}")
            left = [path.name for path in folder.iterdir() if path.suffix in (".new", ".journal")]
            trials.expect(not left, f"left behind: {left}")
        trials.count("chains")
        shutil.rmtree(folder, ignore_errors=True)
    trials.end()


if __name__ == "__main__":
    main()
