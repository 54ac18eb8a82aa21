#!/usr/bin/python3
"""Hold the pages of the documentation against the program: cases on a page are right, commands exist with their
options, and what a page prints below a command is what the command prints.

Usage: test_documents.py [--tier quick|long] [--update] [PAGE...]

quick (the default) runs what takes seconds, long all. --update writes what the commands print now into the page, but
for outputs that are shown in part (with a line ...). Without a page: all that tests/documents/pages.txt lists. How a page says what is to be run: README.md here."""
import argparse
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from compare import REST  # noqa: E402
from page_test import SOURCE, PageTest  # noqa: E402


def listed_pages():
    lines = (Path(__file__).parent / "pages.txt").read_text().split("\n")
    return [line.strip() for line in lines if line.strip() and not line.startswith("#")]


def update(page, updates):
    """Write what commands print into a page in place of what it shows."""
    lines = Path(page).read_text().split("\n")
    for first, last, indent, printed in sorted(updates, reverse=True):
        shown = lines[first - 1:last - 1]
        if any(line.strip() == REST for line in shown):
            print(f"  {page}:{first}: shown in part: to be mended by hand; printed now:\n" + "\n".join(printed))
            continue
        while printed and not printed[-1].strip():
            printed.pop()
        lines[first - 1:last - 1] = [(indent + line).rstrip() for line in printed]
        print(f"  {page}:{first}: written anew")
    Path(page).write_text("\n".join(lines))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", nargs="*", metavar="PAGE")
    parser.add_argument("--tier", choices=("quick", "long"), default="quick")
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()
    os.chdir(SOURCE)
    program = os.environ.get("RIFFLE", "build/ci/bin/riffle")
    good = True
    for page in options.pages or listed_pages():
        test = PageTest(page, program, options.tier)
        good = test.run() and good
        print(f"{page}: " + ", ".join(f"{count} {what}" for what, count in test.counts.items()), flush=True)
        for fault in test.faults:
            print(f"  {fault}", flush=True)
        if options.update and test.updates:
            update(page, test.updates)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
