#!/usr/bin/env python3
"""Holds Riffle against exact solutions and published measurements, and writes a report page.

  tests/verification/verify.py quick      the cheap cases at coarse spacings (CI, under a minute)
  tests/verification/verify.py full       all cases, spacings and option sets (some 23 hours of one core: docs/verification.md)
  tests/verification/verify.py sloshing   one case

Runs go through the program (`riffle run`), numbers come from the results files. Writes verification.html (--page FILE), one file
with the table of error norms and bars, a figure and the budgets of each case; --markdown FILE writes the tables too, --figures DIR
the figures as SVG. --keep DIR keeps the results there, --reuse takes complete results that DIR already holds, --continue those of this
binary alone, and goes on with runs that were broken off. Ends with status 1 when a bar is missed that is not among the known ones (tests/known_misses.toml), or one of those has become worse or has gone,
and when a page of the documentation shows another number of a case that was run whole (tests/shown_tables.py; --write-pages writes the rows of today into it).
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / "validation"), str(pathlib.Path(__file__).resolve().parents[1])]

import h5py  # noqa: E402

import check as checks  # noqa: E402
import on_pages  # noqa: E402
import page  # noqa: E402
import runs  # noqa: E402
import shown_tables  # noqa: E402
import bed_checks  # noqa: E402
import body_checks  # noqa: E402
import canal_checks  # noqa: E402
import flood_checks  # noqa: E402
import inflow_checks  # noqa: E402
import jump_checks  # noqa: E402
import open_end_checks  # noqa: E402
import overflow_checks  # noqa: E402
import porous_checks  # noqa: E402
import rapid_checks  # noqa: E402
import resolved_bed_checks  # noqa: E402
import scheme_checks  # noqa: E402
import solid_checks  # noqa: E402
import stream_checks  # noqa: E402
import surface_checks  # noqa: E402
import turbulence_checks  # noqa: E402
import vegetation_checks  # noqa: E402
import violent_checks  # noqa: E402
import viscous_checks  # noqa: E402
from flow import Flow  # noqa: E402
from table import Table  # noqa: E402

CHECKS = viscous_checks.CHECKS | surface_checks.CHECKS | violent_checks.CHECKS | scheme_checks.CHECKS | turbulence_checks.CHECKS | resolved_bed_checks.CHECKS | open_end_checks.CHECKS | inflow_checks.CHECKS | canal_checks.CHECKS | overflow_checks.CHECKS | rapid_checks.CHECKS | jump_checks.CHECKS | vegetation_checks.CHECKS | body_checks.CHECKS | porous_checks.CHECKS | stream_checks.CHECKS | solid_checks.CHECKS | bed_checks.CHECKS | flood_checks.CHECKS
QUICK = ["poiseuille", "couette", "taylor_green_re100", "tank", "drop", "emergent_stems", "submerged_formula", "brinkman", "inclined_plate"]


class Study:
    """Makes the runs of the checks, each once."""

    def __init__(self, riffle, folder, quick, reuse, threads):
        self.riffle, self.folder, self.quick, self.reuse, self.threads = riffle, folder, quick, reuse, threads
        self.done = {}

    def run(self, name, case, settings=None):
        key = (case, tuple(sorted((settings or {}).items())))
        if key not in self.done:
            self.done[key] = Flow(self.riffle, case, self.folder / name, settings or {}, self.reuse, self.threads)
        return self.done[key]

    def try_run(self, name, case, settings):
        """As run, but None where the simulation fails: some option sets do."""
        try:
            return self.run(name, case, settings)
        except SystemExit as failure:
            print(f"{name}: {str(failure).splitlines()[-1]}", file=sys.stderr)
            return None

    def findings(self, flow, *arguments):
        """Values of the findings of `riffle analyse` of a run, by their keys."""
        analysis = flow.folder / "analysis.json"
        subprocess.run([self.riffle, "analyse", flow.folder, *arguments, "--json", analysis], check=True, capture_output=True)
        return {f["key"]: f["value"] for a in json.loads(analysis.read_text())["analyses"] for f in a["findings"]}

    def column(self, flow):
        """z and u of the run's column twin."""
        with h5py.File(flow.folder / "results.h5", "r") as file:
            return file["/column/z"][:], file["/column/velocity"][:]

    def table(self, title, header, rows):
        table = Table(title, header)
        table.rows = rows
        return table


def build_of(study):
    """The program that made the runs, in words; some checks ask it for twins alone and make none."""
    if study.done:
        return next(iter(study.done.values())).build
    version, build, instructions, *_ = subprocess.run([study.riffle, "version"], check=True, capture_output=True, text=True).stdout.splitlines()
    return f"R{version[1:]}, {build.removeprefix('build: ')}, {instructions.removeprefix('instruction set: ').split()[0]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tier", nargs="+", choices=["quick", "full", *CHECKS], metavar="TIER", help="quick, full, or names of cases: " + ", ".join(CHECKS))
    parser.add_argument("--riffle", type=pathlib.Path, help="the binary (default: the build of this checkout)")
    parser.add_argument("--page", type=pathlib.Path, default=pathlib.Path("verification.html"), help="the report page to write")
    parser.add_argument("--markdown", type=pathlib.Path, help="write the tables to this file")
    parser.add_argument("--figures", type=pathlib.Path, help="write the figures as SVG into this folder")
    parser.add_argument("--keep", type=pathlib.Path, help="keep the results in this folder")
    runs.add_reuse_options(parser)
    parser.add_argument("--write-pages", action="store_true", help="write rows that have changed into the pages of docs/ (look at the difference)")
    parser.add_argument("--threads", "-j", type=int, default=0, help="threads of each run (default: all processors that may be used)")
    parser.add_argument("--coarse", action="store_true", help="single names: as in the quick tier, without spacings and option sets")
    arguments = parser.parse_args()
    riffle = (arguments.riffle or runs.default_riffle()).resolve()
    quick = arguments.tier == ["quick"]
    names = QUICK if quick else list(CHECKS) if arguments.tier == ["full"] else [n for n in arguments.tier if n in CHECKS]
    done = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = arguments.keep or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        study = Study(riffle, folder.resolve(), quick or arguments.coarse, arguments.reuse, arguments.threads)
        for name in names:
            done.append(CHECKS[name](study).judge(complete=not study.quick))
            print(checks.text(done[-1]), flush=True)
        build = build_of(study)
    comparison = shown_tables.Comparison([] if study.quick else shown_tables.read())
    for check in [] if study.quick else done:
        on_pages.compare(check, comparison)
    table = checks.summary_table(done)
    budgets = checks.budget_table(done)
    arguments.page.parent.mkdir(parents=True, exist_ok=True)
    arguments.page.write_text(page.html_page(table, budgets, done, build))
    if arguments.markdown:
        arguments.markdown.write_text(page.markdown(table, budgets, done))
    if arguments.figures:
        arguments.figures.mkdir(parents=True, exist_ok=True)
        for check in done:
            for number, (drawing, _) in enumerate(check.figures):
                (arguments.figures / f"verify-{check.name.replace('_', '-')}{'' if number == 0 else f'-{number + 1}'}.svg").write_text(drawing)
    known = [line for check in done for line in check.known]
    for line in known:
        print("KNOWN MISS:", line)
    for line in table.missed:
        print("MISSED:", line)
    print(f"{table.checks - len(table.missed) - len(known)} bars held, {len(table.missed)} missed, {len(known)} known to be missed; page: {arguments.page}")
    return comparison.end(arguments.write_pages) or (1 if table.missed else 0)


if __name__ == "__main__":
    sys.exit(main())
