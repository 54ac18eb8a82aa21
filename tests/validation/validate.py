#!/usr/bin/env python3
"""Holds Riffle's channels against their bars: the column twin, the momentum balance, Table 3.1.

  tests/validation/validate.py quick     condition 2, stirred too, and beside a side wall (CI, some minutes)
  tests/validation/validate.py choices   each choice of the method in condition 2
  tests/validation/validate.py full      all conditions, the paper's case, spacings, stirring, choices, SPS (hours)
  tests/validation/validate.py space     three dimensions: cells of a wide channel, half channels with a side wall (about half an hour)

Prints one table per part and ends with status 1 when a bar is missed, or a known miss (tests/known_misses.toml) has become worse or
has gone, or when docs/validation.md shows another number (tests/shown_tables.py; --write-pages writes the rows of today into it). --markdown FILE writes the tables too,
--keep DIR keeps the results there, --reuse takes complete results that DIR already holds, --continue those of this binary
alone, and goes on with runs that were broken off.
"""

import argparse
import pathlib
import sys
import tempfile

import bed_parts
import choice_parts
import parts
import runs
import shown_tables
import space_parts


ALL_PARTS = parts.PARTS | space_parts.SPACE_PARTS | choice_parts.CHOICE_PARTS | bed_parts.BED_PARTS

TIERS = {"quick": parts.QUICK + ["space_side_quick"], "full": parts.FULL + bed_parts.BEDS + ["choices"], "space": space_parts.SPACE}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tier", choices=[*TIERS] + sorted(ALL_PARTS))
    parser.add_argument("--riffle", type=pathlib.Path, help="the binary (default: the build of this checkout)")
    parser.add_argument("--keep", type=pathlib.Path, help="keep the results in this folder")
    runs.add_reuse_options(parser)
    parser.add_argument("--threads", type=int, default=0, help="threads of each run (default: all processors that may be used)")
    parser.add_argument("--write-pages", action="store_true", help="write rows that have changed into docs/validation.md (look at the difference)")
    parser.add_argument("--markdown", type=pathlib.Path, help="write the tables to this file")
    arguments = parser.parse_args()
    riffle = arguments.riffle or runs.default_riffle()
    names = TIERS.get(arguments.tier, [arguments.tier])
    with tempfile.TemporaryDirectory() as scratch:
        folder = arguments.keep or pathlib.Path(scratch)

        def run(name, case, settings=None):
            return runs.RiffleRun(riffle, case, folder / name, settings or {}, arguments.reuse, arguments.threads)

        tables = []
        for name in names:
            tables.append(ALL_PARTS[name](run))
            tables[-1].judge("validation", name)
            print(tables[-1].text(), flush=True)
    if arguments.markdown:
        arguments.markdown.write_text("\n".join(table.markdown() for table in tables))
    comparison = shown_tables.Comparison(shown_tables.read(pages=["validation.md"]))
    for name, table in zip(names, tables):
        if name not in TIERS["quick"] and not comparison.titled(table.title, table.header, table.rows):
            comparison.faults.append(f"no heading of docs/validation.md is the table of {name}: {table.title}")
    missed = [line for table in tables for line in table.missed]
    known = [line for table in tables for line in table.known]
    for line in known:
        print("KNOWN MISS:", line)
    for line in missed:
        print("MISSED:", line)
    print(f"{sum(table.checks for table in tables) - len(missed) - len(known)} bars held, {len(known)} known to be missed, {len(missed)} missed")
    return comparison.end(arguments.write_pages) or (1 if missed else 0)


if __name__ == "__main__":
    sys.exit(main())
