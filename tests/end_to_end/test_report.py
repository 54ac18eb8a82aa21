"""The report of a run, from the command line and in a browser."""
import json
import os
import shutil
import subprocess
from pathlib import Path

import h5py

from riffle_cli import CASE, RIFFLE, SMALL, SOURCE, CommandLineTest, every, main, start, until, wait_for


class Report(CommandLineTest):
    def test_report_prints_its_path_and_the_summary_as_json(self):
        folder = self.run_small("run", 1)
        printed = self.succeed("report", folder).stdout.split()
        self.assertEqual(printed, [str(folder / "report.html"), str(folder / "summary.json")])
        page, summary = self.folder / "page.html", self.folder / "other.json"
        self.succeed("report", folder / "results.h5", "-o", page, "--json", summary)
        self.assertEqual(page.read_bytes(), (folder / "report.html").read_bytes())
        self.assertEqual(summary.read_bytes(), (folder / "summary.json").read_bytes())
        found = json.loads(summary.read_text())
        self.assertEqual(found["format"], "riffle-report-summary")
        self.assertIn("depth_mean_velocity", found["quantities"])

    def test_several_runs_are_compared_and_named_by_what_differs(self):
        folders = [self.run_small("one", 0.5), self.run_small("two", 0.5, "--set", "turbulence.lambda=0.1")]
        printed = self.succeed("report", *folders, "-o", self.folder / "both.html").stdout.split()
        self.assertEqual(printed, [str(self.folder / "both.html"), str(self.folder / "both-summary.json")])
        summary = json.loads((self.folder / "both-summary.json").read_text())
        self.assertEqual([run["name"] for run in summary["runs"]], ["lambda 0.09", "lambda 0.1"])
        self.assertEqual([row["key"] for row in summary["differences"]], ["turbulence.lambda"])

    def test_report_takes_a_window_and_a_measured_profile_as_analyse_does(self):
        folder = self.run_small("run", 1)
        profile = SOURCE / "cases/laboratory/adv-profile.csv"
        self.succeed("report", folder, "--window", "0.4,0.9", "--measured", profile)
        self.fail_with(2, "report", folder, "--window", "5,9", says=["--window"])

    def test_a_page_of_a_window_is_of_that_window_throughout(self):
        """The quantities of the summary, the health rows and the findings of the analysis alike."""
        folder = self.run_small("window", 1)
        self.succeed("report", folder, "--window", "0.2,0.6")
        summary = json.loads((folder / "summary.json").read_text())
        self.assertEqual(summary["window"], {"start": 0.2, "end": 0.6})
        found = {finding["key"]: finding["value"] for finding in summary["findings"]}
        value = lambda key: summary["quantities"][key]["simulated"]["value"]
        for quantity, finding in (("depth_mean_velocity", "depth_mean_velocity"), ("drag_over_gravity", "bed_drag_share"),
                                  ("friction_velocity", "friction_velocity"), ("friction_factor", "friction_factor")):
            self.assertAlmostEqual(value(quantity) / found[finding], 1, delta=1e-9, msg=quantity)
        with h5py.File(folder / "results.h5") as file:
            series = file["time_series"]
            inside = (series["time"][:] > 0.2 - 1e-6) & (series["time"][:] < 0.6 + 1e-6)
            self.assertAlmostEqual(value("mean_level"), series["mean_level"][:][inside].mean(), delta=1e-9)

    def test_a_laboratory_record_alone_gives_a_page_of_its_name(self):
        record = self.folder / "adv.csv"
        shutil.copy(SOURCE / "cases/laboratory/adv-profile.csv", record)
        printed = self.succeed("report", record, "--case", CASE).stdout.split()
        self.assertEqual([Path(name).resolve() for name in printed],
                         [(self.folder / name).resolve() for name in ("adv.html", "adv-summary.json")])
        self.assertNotIn("1 laboratory record", (self.folder / "adv.html").read_text())

    def test_thesis_chapter_names_the_conditions_that_are_missing(self):
        self.run_small("runs/condition-2", 0.5)
        result = self.succeed("report", "--thesis", self.folder / "runs")
        self.assertTrue((self.folder / "runs/thesis.html").exists())
        summary = json.loads((self.folder / "runs/thesis-summary.json").read_text())
        missing = [row["what"] for row in summary["missing"]]
        for number in (1, 3, 5, 6, 7, 8):
            self.assertIn(f"flow condition {number}", missing)
            self.assertIn(f"flow condition {number} is not among the results", result.stderr)
        self.assertNotIn("flow condition 2", missing)

    def test_script_of_the_thesis_chapter_makes_all_its_runs(self):
        script = [SOURCE / "tools/thesis-chapter.sh", "-o", self.folder / "thesis"]
        coarse = ["--set", "numerics.spacing=2.5mm", "--set", "channel.length=0.06", "--set", "run.until=0.6s"]
        for again in ([], ["complete"]):
            made = subprocess.run([*script, *coarse], capture_output=True, text=True, timeout=240,
                                  env={**os.environ, "RIFFLE": RIFFLE})
            self.assertEqual(made.returncode, 0, made.stderr)
            for words in again:
                self.assertIn(words, made.stdout)
        summary = json.loads((self.folder / "thesis/thesis-summary.json").read_text())
        self.assertEqual(summary["missing"], [])
        self.assertEqual(len(summary["runs"]), 16)

    def test_thesis_pages_of_parts(self):
        self.run_small("runs/condition-2", 0.5)
        self.fail_with(2, "report", "--thesis=7", self.folder / "runs", says=["'7'", "4, 5, 6 and paper"])
        self.fail_with(2, "report", "--thesis=5", self.folder / "runs", says=["none of the 1 runs"])
        self.succeed("report", "--thesis=4", self.folder / "runs")
        summary = json.loads((self.folder / "runs/thesis-summary.json").read_text())
        self.assertNotIn("the paper's case", [row["what"] for row in summary["missing"]])

    def test_thesis_chapter_of_a_folder_without_runs(self):
        (self.folder / "empty").mkdir()
        self.fail_with(3, "report", "--thesis", self.folder / "empty", says=["thesis-chapter.sh"])

    def test_report_of_a_run_that_has_only_started(self):
        folder = self.folder / "run"
        process = start("run", CASE, "-o", folder, *SMALL, *until(1000))
        try:
            wait_for((folder / "checkpoint.h5").exists, "the first checkpoint")
        finally:
            process.kill()
            process.communicate()
        self.succeed("report", folder)
        self.look_at(folder / "report.html", "--partial", "--desk")

    def test_report_to_a_place_that_cannot_be_written(self):
        folder = self.run_small("run", 0.1)
        target = folder / "results.h5" / "report.html"
        self.fail_with(3, "report", folder, "-o", target, says=[str(target)])

    def test_an_output_takes_the_place_of_nothing_else(self):
        folder = self.run_small("run", 0.1)
        results, case = folder / "results.h5", self.folder / "case.toml"
        case.write_text("# mine\n")
        before = results.read_bytes()
        for command in (["report", folder, "-o", results], ["report", folder, "--json", case], ["analyse", folder, "--json", results],
                        ["analyse", folder, "--json", case], ["schema", "-o", case], ["schema", "--markdown", "-o", case]):
            with self.subTest(command=command[0]):
                self.fail_with(2, *command, says=["would be lost", str(command[-1])])
        self.fail_with(2, "report", folder, "-o", self.folder / "page.pdf", says=["page.pdf", "NAME.html", "print it to a file"])
        self.assertFalse((self.folder / "page.pdf").exists())
        tables = self.folder / "tables"
        tables.mkdir()
        for name in ("velocity_history.csv", "findings.csv"):
            mine = tables / name
            mine.write_text("# my flume\nz,u\n")
            self.fail_with(2, "analyse", folder, "--csv", tables, says=["would be lost", str(mine)])
            self.assertEqual([path.name for path in tables.iterdir()], [name], "some tables were written")
            self.assertEqual(mine.read_text(), "# my flume\nz,u\n")
            mine.unlink()
        self.assertEqual(results.read_bytes(), before)
        self.assertEqual(case.read_text(), "# mine\n")
        # Its own older version it may replace, and a device.
        for _ in range(2):
            self.succeed("report", folder)
            self.succeed("analyse", folder, "--json", self.folder / "a.json", "--csv", tables)
            self.succeed("schema", "--markdown", "-o", self.folder / "reference.md")
        self.succeed("analyse", folder, "--json", "/dev/null")

    def test_report_in_a_browser(self):
        folder = self.folder / "run"
        self.succeed("run", CASE, "-o", folder, "-q", *until(6), "--set", "numerics.spacing=2.5mm", "--set",
                     "channel.length=0.1", *every(snapshot=1))
        self.succeed("report", folder)
        self.look_at(folder / "report.html")

    def run_check(self, name, *options):
        """A case of cases/checks, short and coarse, with its report; gives the page and its summary."""
        folder = self.folder / name
        self.succeed("run", SOURCE / f"cases/checks/{name}.toml", "-o", folder, "-q", *options)
        self.succeed("report", folder)
        return folder / "report.html", json.loads((folder / "summary.json").read_text())

    def test_each_kind_of_flow_has_its_verdict(self):
        """A dam break, a step, a wave and vortices are not judged as uniform channels."""
        runs = {
            "dam-break": ("tank", ["--set", "numerics.spacing=5mm", *until(0.6), *every(snapshot=0.1)]),
            "flow-over-step": ("bodies", ["--set", "numerics.spacing=1.6mm", *until(5), "--set", "run.average_from=3", *every(snapshot=0.5)]),
            "standing-wave": ("wave", ["--set", "numerics.spacing=4mm", *until(1)]),
            "taylor-green": ("box", ["--set", "numerics.spacing=40mm", *until(0.5)]),
        }
        kinds = {"tank": "tank", "bodies": "channel-with-bodies", "wave": "standing-wave", "box": "periodic-box"}
        for name, (kind, options) in runs.items():
            with self.subTest(name):
                page, summary = self.run_check(name, *options)
                self.assertEqual(summary["flow_kind"], kinds[kind])
                words = json.dumps([summary["verdict"], [row["key"] for row in summary["diagnostics"]]])
                level = ("twin's",) if kind == "bodies" else ("drift of the water level", "depth_drift")
                for wrong in ("column twin's", "spurious shear stress", "velocity_error", *level):
                    self.assertNotIn(wrong, words)
                # But for a window that is short, so that the test is, nothing is wrong.
                bad = {row["key"] for row in summary["diagnostics"] if row["status"] == "bad"}
                self.assertLessEqual(bad, {"independent_samples"}, summary["verdict"])
                for row in summary["quantities"].values():
                    self.assertIsNone(row["column"])
                self.look_at(page, "--kind", kind, *([] if kind == "bodies" else ["--desk"]))

    def test_every_kind_of_figure_in_a_browser(self):
        self.sample_pages()
        self.look_at(self.folder / "report.html", "--figures", "settling,elevation_density,"
                     "elevation_spectrum,elevation_map,wavenumber_frequency,correlation,velocity_field",
                     script="figures_browser.mjs")

    def test_comparison_in_a_browser(self):
        self.sample_pages()
        self.look_at(self.folder / "comparison.html", "--figures", "velocity_profile,elevation_map,velocity_field",
                     "--save", "velocity_profile,elevation_map", "--desk", script="figures_browser.mjs")
        page = (self.folder / "comparison.html").read_text()
        self.assertIn("lambda 0.09", page)

    def test_thesis_chapter_in_a_browser(self):
        self.sample_pages()
        self.look_at(self.folder / "thesis.html", "--save", "velocity_profile", script="figures_browser.mjs")

    def test_three_dimensions_in_a_browser(self):
        self.sample_pages()
        self.look_at(self.folder / "space.html", "--figures", "section_velocity_map,section_stress_map,"
                     "secondary_strength_averaging,bed_stress_distribution,drag_plan_map,surface_mean_map,moving-surface",
                     "--save", "section_velocity_map,bed_stress_distribution,moving-surface", script="figures_browser.mjs")
        self.look_at(self.folder / "dimensions.html", "--figures", "velocity_profile,section_velocity_map",
                     "--save", "velocity_profile", "--desk", script="figures_browser.mjs")
        self.assertIn("computing time per simulated second", (self.folder / "dimensions.html").read_text())

    def sample_pages(self):
        program = os.environ.get("RIFFLE_SAMPLE_REPORT")
        if not program:
            self.skipTest("no RIFFLE_SAMPLE_REPORT: the program tests/end_to_end/sample_report.cpp")
        subprocess.run([program, self.folder], check=True, timeout=60)

    def look_at(self, page, *options, script="report_browser.mjs"):
        self.need_browser()
        browser = subprocess.run(["node", SOURCE / "tests/end_to_end" / script, page, *options],
                                 capture_output=True, text=True, timeout=900)
        self.assertEqual(browser.returncode, 0, browser.stdout + browser.stderr)


if __name__ == "__main__":
    main()
