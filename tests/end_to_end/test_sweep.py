"""A sweep: all combinations, taken up again where it was left, one failing run among them, refusals."""
import csv
import json
import math
import shutil
import signal
import subprocess
import time

from riffle_cli import BROWSER, CASE, SMALL, CommandLineTest, every, kept_files, main, start, until, wait_for

# Some hundred particles, a fraction of a second each.
TINY = ["--set", "channel.length=0.06", *until(0.2)]
MATRIX = ["--vary", "numerics.spacing=4mm,3mm,2.5mm", "--vary", "turbulence.lambda=0.09,0.1"]
NAMES = [f"spacing={spacing}_lambda={factor}" for spacing in ("4mm", "3mm", "2.5mm") for factor in ("0.09", "0.1")]


class Sweep(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.sweep = self.folder / "sweep"

    def summary(self):
        return json.loads((self.sweep / "sweep.json").read_text())

    def states(self):
        return {run["name"]: run["state"] for run in self.summary()["runs"]}

    def test_all_combinations_become_results_folders_a_table_and_figures(self):
        printed = self.succeed("sweep", CASE, *MATRIX, *TINY, "-o", self.sweep, "--jobs", 2, "-j", 2).stdout
        self.assertEqual(self.states(), dict.fromkeys(NAMES, "complete"))
        self.assertEqual([run["name"] for run in self.summary()["runs"]], NAMES)
        for name in NAMES:
            self.assert_readable(self.sweep / name)
            self.assertIn(name, printed)
        # An ordinary results folder: the same as that of `riffle run`, whatever the threads.
        alone = self.folder / "alone"
        self.succeed("run", CASE, *TINY, "--set", "numerics.spacing=3mm", "--set", "turbulence.lambda=0.1", "-o", alone, "-j", 1, "-q")
        self.assert_same_results(alone, self.sweep / NAMES[3])
        with (self.sweep / "sweep.csv").open() as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["run"] for row in rows], NAMES)
        found = self.summary()
        import h5py
        with h5py.File(alone / "results.h5", "r") as file:
            expected = float(file["/summary"].attrs["depth_mean_velocity"])
            twin = float(file["/column"].attrs["depth_mean_velocity"])
        value = found["runs"][3]["outcomes"]["depth_mean_velocity"]
        self.assertEqual((value["value"], value["twin"]), (expected, twin))
        self.assertAlmostEqual(float(rows[3]["depth_mean_velocity [m/s]"]), expected, places=7)
        studies = [study for study in found["refinements"] if study["outcome"] == "depth_mean_velocity"]
        self.assertEqual([(study["others"], len(study["sizes"])) for study in studies], [("lambda=0.09", 3), ("lambda=0.1", 3)])
        for study in studies:
            self.assertIn(study["refinement"], ("monotone", "oscillating", "diverging", "not-asymptotic", "within-noise", "unchanged"))
            self.assertTrue(study["finding"])

    def test_the_same_command_again_changes_no_run(self):
        command = ["sweep", CASE, "--vary", "numerics.spacing=4mm,3mm", *TINY, "-o", self.sweep, "-q"]
        self.succeed(*command)
        # Two runs leave no scatter by which to know an order of departures.
        findings = [study["finding"] for study in self.summary()["refinements"]]
        self.assertIn("an order of convergence needs three", " ".join(findings))
        self.assertNotIn("fitted order", " ".join(findings))
        before = {path: data for path, data in kept_files(self.sweep).items() if path.parent != self.sweep}
        self.succeed(*command, "--outcome", "mean_level", "--outcome", "drag_over_gravity")
        self.assertEqual(before, {path: data for path, data in kept_files(self.sweep).items() if path.parent != self.sweep})
        self.assertEqual([outcome["key"] for outcome in self.summary()["outcomes"]], ["mean_level", "drag_over_gravity"])

    def test_a_stopped_and_a_killed_sweep_go_on_bit_by_bit(self):
        matrix = ["--vary", "turbulence.lambda=0.09,0.1", "--set", "numerics.spacing=3mm", "--set", "channel.length=0.06", *until(12),
                  *every(checkpoint=0.02, snapshot=1)]
        straight = self.folder / "straight"
        self.succeed("sweep", CASE, *matrix, "-o", straight, "-q", "--jobs", 2, "-j", 2)
        command = ["sweep", CASE, *matrix, "-o", self.sweep, "--jobs", 2, "-j", 2]
        names = ["lambda=0.09", "lambda=0.1"]

        def begun():
            return all((self.sweep / name / "checkpoint.h5").exists() for name in names)

        process = start(*command)
        wait_for(begun, "the first checkpoints of both runs")
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 128 + signal.SIGINT, errors)
        self.assertIn("same command", output)
        self.assertEqual(set(self.states().values()), {"stopped"})
        # Killed: the runs see to their own checkpoints, and no other sweep may begin before they have.
        process = start(*command)
        time.sleep(0.5)
        process.kill()
        process.communicate()
        self.assertNotEqual(process.returncode, 0)
        wait_for(lambda: subprocess.run(["flock", "-n", self.sweep / ".sweep.lock", "true"]).returncode == 0, "the runs of the killed sweep")
        printed = self.succeed(*command).stdout
        self.assertIn("resumed", printed)
        for name in names:
            self.assert_same_results(straight / name, self.sweep / name)

    def test_a_second_sweep_in_the_same_folder_is_refused_meanwhile(self):
        command = ["sweep", CASE, "--vary", "numerics.spacing=2.5mm", "--set", "channel.length=0.06", *until(60), "-o", self.sweep]
        process = start(*command)
        wait_for((self.sweep / "spacing=2.5mm" / "checkpoint.h5").exists, "the first checkpoint")
        self.fail_with(3, *command, says=["another sweep", str(self.sweep)])
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 128 + signal.SIGTERM)

    def test_a_run_that_fails_does_not_stop_the_others(self):
        # A step far beyond what the sound speed allows.
        command = ["sweep", CASE, "--vary", "numerics.time_step=0.1ms,5ms,0.2ms", "--set", "numerics.spacing=4mm", *TINY, "-o", self.sweep]
        failed, others = "time_step=5ms", ["time_step=0.1ms", "time_step=0.2ms"]
        self.fail_with(1, *command, says=[failed, "checkpoint"])
        self.assertEqual(self.states(), {failed: "failed", **dict.fromkeys(others, "complete")})
        log = (self.sweep / failed / "run.log").read_bytes()
        # Again: it is reported, not repeated; --force repeats it.
        self.fail_with(1, *command, says=[failed, "failed before"])
        self.assertEqual((self.sweep / failed / "run.log").read_bytes(), log)
        self.fail_with(1, *command, "--force", says=[failed])
        self.assertGreater(len((self.sweep / failed / "run.log").read_bytes()), len(log))
        self.assertEqual(self.states()[failed], "failed")

    def test_results_of_another_case_are_refused_without_force(self):
        command = ["sweep", CASE, "--vary", "numerics.spacing=4mm,3mm", "--set", "channel.length=0.06", "-o", self.sweep, "-q"]
        self.succeed(*command, *until(0.2))
        before = kept_files(self.sweep)
        self.fail_with(3, *command, *until(0.1), says=["spacing=4mm", "run.until", "0.2 s", "--force"])
        self.assertEqual(before, kept_files(self.sweep))
        self.succeed(*command, *until(0.1), "--force")
        self.assertEqual(set(self.states().values()), {"complete"})

    def test_dry_run_lists_the_matrix_with_its_cost_and_writes_nothing(self):
        printed = self.succeed("sweep", CASE, *MATRIX, *TINY, "-o", self.sweep, "--dry-run").stdout
        self.assertFalse(self.sweep.exists())
        lines = printed.splitlines()
        self.assertEqual([line.split()[0] for line in lines[1:7]], NAMES)
        self.assertIn("particles", lines[0])
        self.assertIn("6 runs, 6 of them to be done", printed)
        shutil.rmtree(self.sweep, ignore_errors=True)
        self.succeed("sweep", CASE, "--vary", "numerics.spacing=4mm", "--vary", "turbulence.lambda=0.1", *TINY, "-o", self.sweep, "-q")
        self.assertIn("6 runs, 5 of them to be done", self.succeed("sweep", CASE, *MATRIX, *TINY, "-o", self.sweep, "--dry-run").stdout)

    def test_bad_values_are_refused_before_any_run(self):
        for arguments, says in (
                (["--vary", "numerics.spacing=4mm,-3mm"], ["spacing=-3mm", "greater than 0"]),
                (["--vary", "numerics.spacin=4mm,3mm"], ["did you mean `spacing`"]),
                (["--vary", "numerics.kernel=wendland-c2,cubic"], ["kernel=cubic", "cubic-spline"]),
                (["--vary", "numerics.spacing"], ["KEY=V1,V2"]),
                (["--vary", "numerics.spacing=4mm", "--set", "numerics.spacing=3mm"], ["both set"]),
                (["--vary", "numerics.spacing=4mm,0.004"], ["same case"]),
                (["--vary", "numerics.spacing=4mm", "--outcome", "mean_levl"], ["did you mean mean_level"]),
                ([], ["--vary"])):
            with self.subTest(arguments=arguments):
                self.fail_with(2, "sweep", CASE, *arguments, *TINY, "-o", self.sweep, says=says)
                self.assertFalse(self.sweep.exists())
        self.fail_with(3, "sweep", self.folder / "none.toml", "--vary", "numerics.spacing=4mm", says=["none.toml"])

    def test_the_page_draws_tables_and_figures(self):
        self.need_browser(driver=False)
        self.succeed("sweep", CASE, *MATRIX, *TINY, *until(0.4), "-o", self.sweep, "-q")
        page = (self.sweep / "sweep.html").as_uri()
        drawn = subprocess.run([BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--window-size=1200,8000", "--virtual-time-budget=20000",
                                "--dump-dom", page], capture_output=True, text=True, timeout=120).stdout
        for name in ("The runs", "Convergence", "The outcomes"):
            self.assertIn(f"<h2>{name}</h2>", drawn)
        tables = math.ceil(len(self.summary()["outcomes"]) / 5)
        self.assertEqual(drawn.count("<tr data-run="), tables * len(NAMES))
        self.assertIn('id="figure-sweep_depth_mean_velocity"', drawn)
        self.assertIn('id="figure-sweep_velocity_error_above_rms_order"', drawn)
        self.assertIn("main-svg", drawn, "no figure was drawn")


if __name__ == "__main__":
    main()
