"""The report of a run, from the command line and in a browser."""
import json
import os
import shutil
import subprocess
from pathlib import Path

from riffle_cli import CASE, SMALL, SOURCE, CommandLineTest, every, main, start, until, wait_for

CHROMIUM = os.environ.get("CHROMIUM", "/usr/bin/chromium")


class Report(CommandLineTest):
    def test_report_prints_its_path_and_the_summary_as_json(self):
        folder = self.run_small("run", 1)
        printed = self.succeed("report", folder).stdout.split()
        self.assertEqual(printed, [str(folder / "report.html")])
        page, summary = self.folder / "page.html", self.folder / "summary.json"
        self.succeed("report", folder / "results.h5", "-o", page, "--json", summary)
        self.assertEqual(page.read_bytes(), (folder / "report.html").read_bytes())
        self.assertTrue(json.loads(summary.read_text()))

    def test_report_of_a_run_that_has_only_started(self):
        folder = self.folder / "run"
        process = start("run", CASE, "-o", folder, *SMALL, *until(1000))
        try:
            wait_for((folder / "checkpoint.h5").exists, "the first checkpoint")
        finally:
            process.kill()
            process.communicate()
        self.succeed("report", folder)
        self.look_at(folder / "report.html", "--partial")

    def test_report_to_a_place_that_cannot_be_written(self):
        folder = self.run_small("run", 0.1)
        target = folder / "results.h5" / "report.html"
        self.fail_with(3, "report", folder, "-o", target, says=[str(target)])

    def test_report_in_a_browser(self):
        folder = self.folder / "run"
        self.succeed("run", CASE, "-o", folder, "-q", *until(6), "--set", "numerics.spacing=2.5mm", "--set",
                     "channel.length=0.1", *every(snapshot=1))
        self.succeed("report", folder)
        self.look_at(folder / "report.html")

    def look_at(self, page, *options):
        if not shutil.which("node") or not Path(CHROMIUM).exists():
            self.skipTest(f"no node or no browser at {CHROMIUM} (packages nodejs, chromium)")
        if not (SOURCE / "web/node_modules/playwright-core").exists():
            self.skipTest("no playwright-core: npm ci --prefix web")
        browser = subprocess.run(["node", SOURCE / "tests/end_to_end/report_browser.mjs", page, *options],
                                 capture_output=True, text=True, timeout=240)
        self.assertEqual(browser.returncode, 0, browser.stdout + browser.stderr)


if __name__ == "__main__":
    main()
