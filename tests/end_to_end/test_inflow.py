"""Water of one run that enters another one, and channels with open ends that start from results."""

import pathlib
import shutil
import tempfile

from riffle_cli import SPACE_CASE, CommandLineTest, every, main, riffle, until

CELL = SPACE_CASE.replace("czernuszenko-rylov", "ramp")

# What turns the periodic cell into a channel that the cell's water enters.
OPEN = """
[inflow]
unit_discharge = "0.0174 m2/s"
profile = "results"
results = "{results}"
[outflow]
kind = "depth"
depth = "50 mm"
"""


class Inflow(CommandLineTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.shared = tempfile.TemporaryDirectory(prefix="riffle-test-")
        cls.addClassCleanup(cls.shared.cleanup)
        case = pathlib.Path(cls.shared.name) / "cell.toml"
        case.write_text(CELL)
        made = riffle("run", case, "-o", case.parent / "cell", "-q", *until(0.3), *every(snapshot=0.05))
        assert made.returncode == 0, made.stderr

    def setUp(self):
        super().setUp()
        shutil.copytree(pathlib.Path(self.shared.name) / "cell", self.folder / "cell")
        (self.folder / "cell.toml").write_text(CELL)
        self.cell = self.folder / "cell"

    def case(self, more="", results=None, name="open.toml"):
        text = CELL.replace('length = "50 mm"', 'length = "250 mm"\nends = "open"')
        path = self.folder / name
        path.write_text(text.replace('[output]\nmean_field_interval = "0.15 s"\n', "")
                        + OPEN.format(results=results or self.cell / "results.h5") + more)
        return path

    def run_open(self, name, seconds, *options, threads=1):
        folder = self.folder / name
        self.succeed("run", self.case(), "-o", folder, "-j", threads, "-q", *until(seconds), *options)
        return folder

    def test_what_happens_at_the_ends_is_told_on_the_terminal_too(self):
        case = self.folder / "surge.toml"
        case.write_text("""[channel]
slope = 0
depth = "60 mm"
length = "0.4 m"
ends = "open"
[inflow]
unit_discharge = "0.01 m2/s"
profile = "uniform"
[outflow]
kind = "depth"
depth = "90 mm"
relaxation_time = "0.2 s"
[bed]
kind = "slip"
[turbulence]
closure = "none"
[numerics]
spacing = "5 mm"
""")
        told = "water comes in through the outflow"
        loud = self.succeed("run", case, "-o", self.folder / "loud", *until(0.4))
        self.assertIn(f"riffle: warning: {told}", loud.stderr)
        quiet = self.succeed("run", case, "-o", self.folder / "quiet", "-q", *until(0.4))
        self.assertNotIn(told, quiet.stderr)
        for folder in ("loud", "quiet"):
            self.assertIn(told, (self.folder / folder / "run.log").read_text())

    def test_the_water_of_another_run_enters_with_the_discharge_of_the_case(self):
        import h5py
        import numpy

        folder = self.run_open("open", 0.6, *every(snapshot=0.1))
        with h5py.File(folder / "results.h5") as file, h5py.File(self.cell / "results.h5") as cell:
            series = {name: file[f"time_series/{name}"][:] for name in
                      ("time", "inflow_discharge", "particles_stored", "particles_entered", "particles_left", "particles_lost")}
            late = series["time"] > 0.2
            self.assertLess(abs(series["inflow_discharge"][late].mean() / (0.0174 * 0.0433013) - 1), 0.02)
            account = series["particles_stored"] - series["particles_entered"] + series["particles_left"] + series["particles_lost"]
            self.assertEqual(numpy.ptp(account), 0)
            self.assertGreater(series["particles_entered"][-1], 300)

            def rows(snapshot, far):
                position, velocity = snapshot["position"][:], snapshot["velocity"][:]
                here = (position[:, 0] >= 0) & (position[:, 0] < far)
                row = (position[here, 2] / 5.6e-3).astype(int).clip(0, 9)
                return numpy.bincount(row, velocity[here, 0], 10) / numpy.bincount(row, minlength=10)

            last = lambda results: results["snapshots"][sorted(results["snapshots"])[-1]]
            entered, recorded = rows(last(file), 0.05), rows(last(cell), 1.0)
            scale = 0.0174 / 0.056 / recorded.mean()
            self.assertLess(numpy.sqrt(((entered / recorded / scale - 1) ** 2)[2:].mean()), 0.06)

    def test_the_same_bits_with_two_threads_and_after_a_resume(self):
        one = self.run_open("one", 0.2)
        self.assert_same_results(one, self.run_open("two", 0.2, threads=2))
        part = self.run_open("part", 0.1)
        self.succeed("resume", part, "-q", *until(0.2))
        self.assert_same_results(one, part)

    def test_what_enters_must_stay_the_file_that_it_was(self):
        part = self.run_open("part", 0.1)
        with open(self.cell / "results.h5", "ab") as file:
            file.write(b"\0" * 8)
        self.fail_with(2, "resume", part, "-q", *until(0.2), says=["inflow.results", "is not the file that it was"])

    def test_a_run_is_read_without_the_water_that_entered_and_not_resumed(self):
        folder = self.run_open("part", 0.3)
        (self.cell / "results.h5").unlink()
        self.succeed("analyse", folder)
        self.succeed("report", folder, "-o", self.folder / "report.html")
        self.fail_with(2, "resume", folder, "-q", *until(0.4), says=["inflow.results", "is gone"])

    def test_a_hydrograph_must_stay_the_file_that_it_was(self):
        table = self.folder / "flood.csv"
        table.write_text("time,unit_discharge\n0,0.0174\n1,0.02\n")
        path = self.case(name="flood.toml")
        path.write_text(path.read_text().replace('unit_discharge = "0.0174 m2/s"', 'discharge_file = "flood.csv"'))
        folder = self.folder / "flood"
        self.succeed("run", path, "-o", folder, "-q", *until(0.05))
        table.write_text("time,unit_discharge\n0,0.0174\n1,0.03\n")
        self.fail_with(2, "resume", folder, "-q", *until(0.1), says=["inflow.discharge_file", "is not the file that it was"])

    def test_water_that_does_not_fit_is_refused_with_what_to_do(self):
        def refused(case, *words):
            self.fail_with(2, "check", case, says=["[inflow] results", *words])

        wide = self.folder / "wide.toml"
        wide.write_text((self.folder / "cell.toml").read_text().replace("43.3013 mm", "86.6026 mm"))
        self.succeed("run", wide, "-o", self.folder / "wide", "-q", *until(0.05))
        refused(self.case(results=self.folder / "wide" / "results.h5"), "channel.width is 0.0866026 m there and 0.0433013 m here", "several times")
        plain = self.folder / "plain"
        self.succeed("run", self.folder / "cell.toml", "-o", plain, "-q", *until(0.05), "--set", 'output.snapshot_fields="pressure"')
        refused(self.case(results=plain / "results.h5"), "no snapshots with velocities")
        late = self.case(name="late.toml")
        late.write_text(late.read_text().replace('profile = "results"', 'profile = "results"\nresults_from = "9 s"'))
        refused(late, "from 9 s on", "inflow.results_from")
        deep = self.case(name="deep.toml")
        deep.write_text(deep.read_text().replace('depth = "50 mm"\nlength', 'depth = "60 mm"\nlength'))
        refused(deep, "0.056 m deep in all and here 0.066 m")
        still = self.folder / "still"
        self.succeed("run", self.folder / "cell.toml", "-o", still, "-q", *until(0.1), *every(snapshot=0.05), "--set", "start.kind=rest")
        refused(self.case(results=still / "results.h5"), "at 0 s", "inflow.results_from")
        opened = self.run_open("open", 0.05)
        refused(self.case(results=opened / "results.h5"), 'ends = "open"', "periodic")

    def test_a_channel_with_open_ends_starts_from_results(self):
        import h5py

        # From the cell, five times as long, then from that channel itself, its particles as they are.
        source = lambda results: ["--set", "start.kind=results", "--set", f'start.file="{results / "results.h5"}"']
        first = self.run_open("first", 0.1, *source(self.cell))
        second = self.run_open("second", 0.1, *source(first))
        with h5py.File(self.cell / "results.h5") as cell, h5py.File(first / "results.h5") as a, h5py.File(second / "results.h5") as b:
            end = lambda file, name: file[f"time_series/{name}"][-1]
            start = lambda file, name: file[f"time_series/{name}"][0]
            self.assertLess(abs(start(a, "depth_mean_velocity") / end(cell, "depth_mean_velocity") - 1), 0.02)
            self.assertLess(abs(start(b, "depth_mean_velocity") / end(a, "depth_mean_velocity") - 1), 0.005)
            self.assertLess(abs(start(b, "mean_level") / end(a, "mean_level") - 1), 0.005)
            self.assertLess(abs(start(b, "outflow_depth") / end(a, "outflow_depth") - 1), 0.02)
            numbers = b["state/id"][:]
            self.assertEqual(len(set(numbers)), len(numbers))
        # A periodic run of the same length and spacing goes on between open ends with its particles.
        long = self.folder / "long.toml"
        long.write_text((self.folder / "cell.toml").read_text().replace('length = "50 mm"', 'length = "250 mm"'))
        reach = self.folder / "reach"
        self.succeed("run", long, "-o", reach, "-q", *until(0.1))
        third = self.run_open("third", 0.1, *source(reach))
        with h5py.File(reach / "results.h5") as a, h5py.File(third / "results.h5") as b:
            self.assertLess(abs(b["time_series/mean_level"][0] / a["time_series/mean_level"][-1] - 1), 0.005)
            self.assertLess(abs(b["time_series/mean_level"][-1] / a["time_series/mean_level"][-1] - 1), 0.02)
            self.assertEqual(len(set(b["state/id"][:])), b["state/id"].shape[0])
        self.fail_with(2, "run", long, "-o", self.folder / "back", "-q", *until(0.1), *source(first),
                       says=['channel.ends is "open" there and "periodic" here'])


DRAINING = """
[channel]
slope = 0.02
depth = "60 mm"
length = "0.4 m"
ends = "open"
[inflow]
unit_discharge = 0
profile = "uniform"
[outflow]
kind = "free-fall"
[bed]
kind = "slip"
[turbulence]
closure = "none"
[numerics]
preset = "violent"
spacing = "5 mm"
[start]
kind = "rest"
[run]
until = "4.5 s"
"""


class EndEvents(CommandLineTest):
    def test_an_outflow_that_runs_dry_is_in_the_log(self):
        case = self.folder / "draining.toml"
        case.write_text(DRAINING)
        self.succeed("run", case, "-o", self.folder / "out", "-q")
        warnings = [line for line in (self.folder / "out" / "run.log").read_text().splitlines() if " warning " in line]
        self.assertEqual(len([line for line in warnings if "the outflow ran dry at t = " in line]), 1, warnings)


# Uniform water of condition 2 that is then held 10 mm higher at its outflow.
RISING = """
[channel]
slope = 0.004
depth = "50 mm"
length = "0.3 m"
ends = "open"
[inflow]
unit_discharge = "0.0174 m2/s"
[outflow]
kind = "depth"
depth = "60 mm"
relaxation_time = "0.5 s"
[bed]
roughness_height = "0.4 D"
[numerics]
spacing = "5 mm"
[run]
until = "converged"
tolerance = 0.02
maximum_time = "30 s"
"""


class Convergence(CommandLineTest):
    def test_a_channel_runs_until_it_is_steady_and_no_longer(self):
        """From a start that is not; what it then says is what the flow keeps."""
        import h5py

        case = self.folder / "rising.toml"
        case.write_text(RISING)
        said = self.succeed("run", case, "-o", self.folder / "out", "-j", 1).stdout
        self.assertRegex(said, r"converged at t = [\d.]+ s")
        for quantity in ("mean velocity", "the mean level", "the discharge at the outflow"):
            self.assertIn(quantity, said)

        def of(folder):
            with h5py.File(folder / "results.h5") as file:
                summary = dict(file["summary"].attrs)
                return {name: summary[name] for name in ("converged", "window_start", "window_end", "mean_level",
                                                         "depth_mean_velocity")}

        steady = of(self.folder / "out")
        self.assertEqual(steady["converged"], 1)
        self.assertLess(steady["window_end"], 20)
        self.assertGreater(steady["mean_level"], 0.062)  # of the start: 0.056
        self.succeed("run", case, "-o", self.folder / "long", "-j", 1, "-q", *until(30), "--set", "run.average_from=15")
        lasting = of(self.folder / "long")
        for quantity in ("mean_level", "depth_mean_velocity"):
            self.assertAlmostEqual(steady[quantity] / lasting[quantity], 1, delta=0.02, msg=quantity)

    def test_what_changes_in_time_does_not_converge(self):
        case = self.folder / "rising.toml"
        (self.folder / "q.csv").write_text("time,unit_discharge\n0,0.0174\n9,0.02\n")
        text = RISING.replace('unit_discharge = "0.0174 m2/s"', 'discharge_file = "q.csv"')
        case.write_text(text)
        line = 1 + text.splitlines().index('until = "converged"')
        self.fail_with(2, "check", case, says=[f"rising.toml:{line}:", "[inflow] discharge_file changes in time"])


if __name__ == "__main__":
    main()
