"""The command line itself: help, unknown words, silence, colours, and what each verb prints."""
import json
import fcntl
import os
import pty
import re
import struct
import subprocess
import termios
import threading
import tomllib
import xml.etree.ElementTree

from riffle_cli import CASE, RIFFLE, SMALL, SOURCE, CommandLineTest, every, main, start, until

VERBS = ["new", "check", "preview", "column", "section", "backwater", "calibrate", "run", "resume", "sweep", "report", "analyse", "watch", "bench",
         "schema", "version", "help"]


def places_of(case):
    """About how many particles a case has, from its lengths."""
    keys = tomllib.loads(case.read_text())

    def metres(value):
        number, unit = value.split() if isinstance(value, str) else (value, "m")
        return float(number) * {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6}[unit]

    channel = keys["channel"]
    spacing = metres(keys.get("numerics", {}).get("spacing", "2 mm"))
    width = metres(channel["width"]) / spacing if channel.get("dimensions") == 3 and "width" in channel else 1.0
    return metres(channel["depth"]) * metres(channel.get("length", "0.3 m")) / spacing**2 * width


class CommandLine(CommandLineTest):
    def test_every_verb_has_help_with_options_and_examples_of_its_own(self):
        overview = self.succeed("--help").stdout
        self.assertEqual(overview, self.succeed("help").stdout)
        for verb in VERBS:
            with self.subTest(verb=verb):
                self.assertRegex(overview, rf"(?m)^\s+{verb}\s")
                text = self.succeed(verb, "--help").stdout
                self.assertEqual(text, self.succeed("help", verb).stdout)
                self.assertIn("--help", text)
                examples = re.findall(r"(?m)^  (?:\w+=\w+ )?riffle (\w+)", text.split("Examples:")[1])
                self.assertGreaterEqual(len(examples), 2)
                self.assertEqual(set(examples), {verb})
                widest = max(text.split("Examples:")[0].splitlines(), key=len)
                self.assertLessEqual(len(widest), 80, widest)

    def test_help_of_an_unknown_verb_names_the_nearest(self):
        self.fail_with(2, "help", "swep", says=["unknown verb `swep`", "did you mean `sweep`?"])

    def test_unknown_verb_names_the_nearest(self):
        self.fail_with(2, "rnu", says=["unknown verb `rnu`", "did you mean `run`?", "resume"])

    def test_missing_verb_and_arguments(self):
        self.fail_with(2, says=["verb"])
        self.fail_with(2, "run", says=["case"])
        self.fail_with(2, "run", CASE, "--colour", says=["--colour", "riffle run --help"])
        self.fail_with(2, "run", CASE, "-j", "-3", says=["-3", "0 to"])
        self.fail_with(2, "run", CASE, "-j", "two", says=["two"])

    def test_version(self):
        self.assertRegex(self.succeed("--version").stdout, r"^\d+\.\d+\.\d+")
        text = self.succeed("version").stdout
        for word in ("riffle", "build", "instruction set", "threads"):
            self.assertIn(word, text)

    def test_quiet_prints_nothing(self):
        folder = self.folder / "run"
        result = self.succeed("run", CASE, "-o", folder, "--quiet", *SMALL, *until(0.05))
        self.assertEqual(result.stdout + result.stderr, "")
        result = self.succeed("resume", folder, "--quiet", *until(0.1))
        self.assertEqual(result.stdout + result.stderr, "")

    def test_run_tells_where_the_results_are_and_what_comes_next(self):
        folder = self.folder / "run"
        result = self.succeed("run", CASE, "-o", folder, *SMALL, *until(0.3))
        self.assertIn(str(folder / "results.h5"), result.stdout)
        self.assertIn(f"riffle report {folder}", result.stdout)

    def test_colours_only_on_a_terminal_that_wants_them(self):
        def on_terminal(**environment):
            leader, follower = pty.openpty()
            subprocess.run([RIFFLE, "check", "missing.toml"], stderr=follower, cwd=self.folder,
                           env={**os.environ, "TERM": "xterm", **environment}, check=False)
            os.close(follower)
            text = os.read(leader, 10000).decode()
            os.close(leader)
            return text

        self.assertIn("\x1b[", on_terminal(NO_COLOR=""))
        self.assertNotIn("\x1b", on_terminal(NO_COLOR="1"))
        self.assertNotIn("\x1b", on_terminal(NO_COLOR="", TERM="dumb"))

    def test_no_escape_sequences_on_a_dumb_terminal(self):
        leader, follower = pty.openpty()
        subprocess.run([RIFFLE, "run", CASE, "-o", self.folder / "run", *map(str, [*SMALL, *until(0.1), *every(progress=0.01)])],
                       stdout=subprocess.DEVNULL, stderr=follower, env={**os.environ, "TERM": "dumb"}, check=True)
        os.close(follower)
        text = os.read(leader, 65536).decode()
        os.close(leader)
        self.assertNotIn("\x1b", text)
        self.assertRegex(text, r"(?m)^t = ")

    def progress_on_terminal(self, columns, *arguments, then=None):
        """What a run writes to a terminal so many columns wide; `then`: as wide later."""
        leader, follower = pty.openpty()

        def widen(width):
            fcntl.ioctl(leader, termios.TIOCSWINSZ, struct.pack("HHHH", 24, width, 0, 0))

        widen(columns)
        if then:
            threading.Timer(1.0, widen, [then]).start()
        run = subprocess.Popen([RIFFLE, "run", *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=follower,
                               env={**os.environ, "TERM": "xterm", "NO_COLOR": "1"})
        os.close(follower)
        written = b""
        while True:
            try:
                part = os.read(leader, 65536)
            except OSError:  # the run has ended and closed its side
                break
            if not part:
                break
            written += part
        run.wait()
        os.close(leader)
        return [re.sub(r"\x1b\[\d*[A-Za-z]", "", line).strip("\n\r")
                for line in written.decode().split("\r") if line.strip()]

    def test_progress_fits_the_terminal(self):
        run = [CASE, "-j", "1", *SMALL, *until(1), *every(progress=0.05)]
        shown = {}
        for columns in (40, 80, 200):
            lines = [line for line in self.progress_on_terminal(columns, *run, "-o", self.folder / str(columns))
                     if line.startswith("t = ")]
            self.assertGreater(len(lines), 2)
            self.assertLess(max(map(len, lines)), columns)
            shown[columns] = max(map(len, lines))
        self.assertLess(shown[40], shown[80])
        self.assertGreater(shown[200], 100, "a wide terminal shows all there is")

    def test_progress_follows_the_terminal_that_becomes_narrower(self):
        run = [CASE, "-j", "1", *until(60), *every(progress=0.05), "-o", self.folder / "run"]
        lines = [line for line in self.progress_on_terminal(
            150, *run, "--set", "numerics.spacing=2.5mm", "--set", "channel.length=0.06", *until(30), then=60)
            if line.startswith("t = ")]
        self.assertGreater(max(map(len, lines)), 100)
        self.assertLess(len(lines[-1]), 60)

    def test_progress_in_a_file_is_whole_lines(self):
        result = self.succeed("run", CASE, "-o", self.folder / "run", *SMALL, *until(0.5), *every(progress=0.01))
        lines = [line for line in result.stderr.splitlines() if line.startswith("t = ")]
        self.assertEqual(len(lines), 1, "one line at first, the next after 10 s")
        self.assertIn("M updates/s", lines[0])

    def test_a_run_until_converged_counts_to_where_that_is_expected(self):
        result = self.succeed("run", CASE, "-o", self.folder / "run", *SMALL, *every(progress=0.01), "--set",
                              "run.maximum_time=0.2", "--set", "numerics.spacing=2.5mm")
        self.assertRegex(result.stderr, r"t = [\d.]+ of 0.2 s")  # the latest end comes before
        # At first, ten relaxation times of 4.5 s: seen, the run has shown what it is made for.
        process = start("run", CASE, "-o", self.folder / "other", *SMALL, *every(progress=0.01), "-j", "1", "--set",
                        "run.maximum_time=1000", "--set", "run.tolerance=0.5")
        try:
            said = ""
            while not re.search(r"t = [\d.]+ of about 4\d\.?\d* s", said):
                line = process.stderr.readline()
                self.assertNotEqual(line, "", f"the run has ended: {said}")
                said += line
        finally:
            process.kill()
            process.communicate()

    def test_new_writes_a_case_that_is_valid_and_is_not_overwritten(self):
        case = self.folder / "my flume.toml"
        self.succeed("new", case)
        self.succeed("check", case)
        self.fail_with(2, "new", case, says=[str(case), "--force"])
        self.succeed("new", case, "--force", "--from", "condition-3")
        self.assertIn("condition 3", case.read_text())

    def test_the_template_shows_what_each_key_goes_with(self):
        case = self.folder / "flume.toml"
        self.succeed("new", case)
        text = case.read_text()
        self.assertIn('only with shape = "free-form" and channel.dimensions = 2', text)
        self.assertIn('only with kind = "velocity" or "wave"', text)
        self.assertIn("With dimensions = 3 also: sides.", text)
        self.assertNotIn("l.dimensions =", text.replace("channel.dimensions", ""))
        # Each default, its # removed, may stand there.
        keys = [line[1:] if re.match(r"#\w+ = ", line) else line for line in text.splitlines()]
        case.write_text("\n".join(keys) + "\n")
        self.succeed("check", case)

    def test_check_forecasts_the_run(self):
        forecast = json.loads(self.succeed("check", CASE, "--json", *SMALL, *until(1)).stdout)
        self.assertEqual(forecast["particles"], 24 * 22)
        self.assertEqual(forecast["end_time"], 1)
        self.assertGreater(forecast["steps"], 1 / forecast["time_step"] - 1)
        self.assertGreater(forecast["disk_bytes"], 0)

    def test_help_of_new_names_every_built_in_case(self):
        said = " ".join(self.succeed("help", "new").stdout.split())
        names = self.fail_with(2, "new", self.folder / "x.toml", "--from", "nosuch").stderr.split("built-in cases are ")[1]
        for name in re.sub(r"\s+", " ", names).strip().split(", "):
            kind = re.sub(r"condition-\d", "condition-N" if "-3d" in name else "condition-1", name)
            self.assertIn(kind, said, name)

    def test_files_of_a_run_in_the_wrong_place(self):
        """A results file is no case, a case no folder of a run, and a folder no file to write."""
        run = self.folder / "out"
        self.succeed("run", CASE, "-o", run, "-q", *SMALL, *until(0.02))
        for file in ("results.h5", "checkpoint.h5"):
            self.fail_with(2, "run", run / file, says=["not a case file", f"riffle resume {run}"])
            self.fail_with(3, "resume", run / file, says=["give the folder of the run", f"`riffle resume {run}`"])
        self.fail_with(3, "resume", CASE, says=["is a file: give the folder of the run"])
        self.fail_with(3, "schema", "-o", run, says=["Is a directory", "Give the name of a file"])
        self.assertEqual(sorted(self.folder.glob("*.new")), [])

    def test_backwater_asks_for_the_unit_of_a_depth_in_metres(self):
        warned = self.succeed("backwater", CASE, "--downstream", "80").stderr
        self.assertIn("is 80mm meant?", " ".join(warned.split()))
        for depth in ("80mm", "0.08", "80m"):
            self.assertNotIn("meant", self.succeed("backwater", CASE, "--downstream", depth).stderr)

    def test_backwater_by_mannings_n_is_that_of_the_section_of_a_canal(self):
        # Uniform flow of the trapezoid: A = 0.0675 m2, P = 0.3 + 2 sqrt(2) 0.15 m, Q = A R^(2/3) S^(1/2)/n.
        radius = 0.0675 / (0.3 + 2 * 2**0.5 * 0.15)
        discharge = 0.0675 * radius ** (2 / 3) * (0.001 / (1 + 1e-6) ** 0.5) ** 0.5 / 0.013
        canal = SOURCE / "cases/plane-beds/canal.toml"
        found = json.loads(self.succeed("backwater", canal, "--manning", "0.013", "--downstream", "200mm", "--json", "-").stdout)
        self.assertAlmostEqual(found["discharge"] / discharge, 1, delta=1e-3)
        self.assertAlmostEqual(found["normal_depth"] / 0.15, 1, delta=1e-3)
        self.assertEqual(found["profiles"][0]["name"], "M1")
        stations = found["stations"]
        # Above the banks, at 170 mm, the sides of the channel are upright.
        self.assertAlmostEqual(stations["area"][-1], 0.3 * 0.17 + 0.17**2 + 0.03 * 0.64, delta=1e-5)
        self.assertAlmostEqual(stations["top_width"][-1], 0.64, delta=1e-6)
        self.assertAlmostEqual(stations["velocity"][-1] * stations["area"][-1] / found["discharge"], 1, delta=1e-4)
        level = json.loads(self.succeed("backwater", canal, "--slope", "0", "--discharge", "30 l/s", "--downstream", "200mm", "--length", "100m", "--json", "-").stdout)
        self.assertIsNone(level["normal_depth"])
        self.assertGreater(level["stations"]["depth"][0], 0.2)

    def test_backwater_by_a_given_friction_leaves_stems_out(self):
        said = self.succeed("backwater", SOURCE / "cases/vegetation/submerged.toml", "--manning", "0.03").stdout
        self.assertIn("the stems of the case take no part", " ".join(said.split()))

    def test_progress_shows_no_numbers_before_they_are_recorded(self):
        said = self.succeed("run", CASE, "-o", self.folder / "out", *SMALL, *until(0.2), *every(progress=0.001),
                            "--set", "output.series_interval=0.15").stderr
        self.assertIn("nothing recorded yet", said)
        self.assertNotIn("U 0.0000", said)

    def test_check_prints_the_flow_at_open_ends(self):
        """With the numbers of `riffle backwater`, in words and in JSON."""
        jump = CASE.parents[1] / "open-ends/hydraulic-jump.toml"
        coarse = ("--set", "numerics.spacing=5mm", "--set", "start.kind=uniform")
        ends = json.loads(self.succeed("check", jump, "--json", *coarse).stdout)["ends"]
        told = json.loads(self.succeed("backwater", jump, "--json", "-").stdout)
        self.assertEqual(ends["unit_discharge"], [0.02658, 0.02658])
        for end, station in (("inflow", 0), ("outflow", -1)):
            for key in ("depth", "velocity", "froude"):
                for value in ends[end][key]:
                    self.assertAlmostEqual(value, told["stations"][key][station], places=6, msg=f"{end} {key}")
        self.assertAlmostEqual(ends["outflow"]["critical_depth"][0], told["critical_depth"], places=6)
        self.assertIsNone(ends["outflow"]["normal_depth"])  # the bed is level
        said = " ".join(self.succeed("check", jump, *coarse).stdout.split())
        self.assertRegex(said, r"inflow q = 0\.02658 m2/s, depth 20 mm, U = 1\.329 m/s, Fr = 3\.07\d, supercritical")
        self.assertRegex(said, r"outflow holds 70 mm, U = 0\.3797 m/s, Fr = 0\.466\d, subcritical")
        self.assertIsNone(json.loads(self.succeed("check", CASE, "--json", *SMALL, *until(1)).stdout)["ends"])

    def test_every_case_in_the_tree_is_valid(self):
        """Those of up to 13 000 particles; that the others can be read is a unit test (ShippedCases.AllParse)."""
        cases = sorted(case for case in SOURCE.glob("cases/**/*.toml") if places_of(case) < 1.3e4)
        self.assertGreater(len(cases), 60)
        self.assertTrue(any(tomllib.loads(case.read_text())["channel"].get("dimensions") == 3 for case in cases))
        self.assertTrue(any(tomllib.loads(case.read_text()).get("start", {}).get("packed") for case in cases))
        for case in cases:
            with self.subTest(case=case.name):
                self.succeed("check", case, "--json")

    def test_column_prints_the_twin(self):
        twin = json.loads(self.succeed("column", CASE, "--json").stdout)
        self.assertAlmostEqual(twin["depth_mean_velocity"], 0.35, delta=0.035)
        self.assertEqual(len(twin["profile"]["z"]), len(twin["profile"]["u"]))
        lines = self.succeed("column", CASE, "--csv").stdout.splitlines()
        self.assertEqual(len(lines) - 1, len(twin["profile"]["z"]))
        self.assertIn("Reynolds", self.succeed("column", CASE).stdout)

    def test_backwater_of_a_case_with_open_ends_is_that_of_its_ends(self):
        jump = CASE.parents[1] / "open-ends/hydraulic-jump.toml"
        told = json.loads(self.succeed("backwater", jump, "--json", "-").stdout)
        self.assertEqual([profile["name"] for profile in told["profiles"]], ["H3", "H2"])
        self.assertAlmostEqual(told["unit_discharge"], 0.02658)
        depth = told["stations"]["depth"]
        self.assertAlmostEqual(depth[0], 0.02)
        self.assertAlmostEqual(depth[-1], 0.07)
        self.assertEqual(told["stations"]["x"][-1], 1.0)
        # What is asked for goes before what the case says.
        other = json.loads(self.succeed("backwater", jump, "--discharge", "0.02 m2/s", "--length", "2", "--json", "-").stdout)
        self.assertAlmostEqual(other["unit_discharge"], 0.02)
        self.assertEqual(other["stations"]["x"][-1], 2.0)
        # The end that an option leaves open is that of the case, and so is the length.
        held = json.loads(self.succeed("backwater", jump, "--downstream", "75mm", "--json", "-").stdout)
        self.assertAlmostEqual(held["stations"]["depth"][0], 0.02)
        self.assertAlmostEqual(held["stations"]["depth"][-1], 0.075)
        self.assertEqual(held["stations"]["x"][-1], 1.0)

    def test_backwater_of_another_flow_ends_at_its_own_normal_depth(self):
        """`[outflow] kind = "normal-depth"`, the default, holds that of the slope, the discharge and the friction that are asked for."""
        uniform = CASE.parents[1] / "open-ends/uniform.toml"
        for options in (["--slope", "0.008"], ["--discharge", "40l/s"], ["--manning", "0.03"]):
            told = json.loads(self.succeed("backwater", uniform, *options, "--json", "-").stdout)
            self.assertEqual([profile["name"] for profile in told["profiles"]], ["uniform"], options)
            self.assertAlmostEqual(told["stations"]["depth"][-1], told["normal_depth"], places=9, msg=str(options))
        self.fail_with(2, "backwater", uniform, "--slope", "0", "--discharge", "0.0174 m2/s", says=["normal depth", "--downstream"])

    def test_backwater_counts_depths_at_the_ends_from_what_the_water_stands_on(self):
        sill = self.folder / "sill.toml"
        sill.write_text((CASE.parents[1] / "open-ends/backwater-m1.toml").read_text() +
                        '\n[[solid]]\nname = "sill"\nx = ["1 m", "3 m", "3 m", "1 m"]\nz = ["0 mm", "0 mm", "20 mm", "20 mm"]\n')
        held = json.loads(self.succeed("check", sill, "--set", "start.kind=uniform", "--json").stdout)["ends"]["outflow"]["depth"][0]
        told = json.loads(self.succeed("backwater", sill, "--set", "start.kind=uniform", "--json", "-").stdout)
        self.assertAlmostEqual(told["stations"]["depth"][-1], held, places=9)

    def test_backwater_says_what_takes_no_part(self):
        weir = CASE.parents[1] / "open-ends/broad-crested-weir.toml"
        told = " ".join(self.succeed("backwater", weir, "--manning", "0.012", "--downstream", "120mm").stdout.split())
        self.assertIn("solids of the case take no part", told)
        # A bed that nothing brakes has no friction of its own: the way on is named.
        self.fail_with(2, "backwater", weir, "--set", "bed.kind=slip", says=["--manning", "--equivalent-roughness"])

    def test_backwater_over_beds_of_two_roughnesses(self):
        case = CASE.parents[1] / "plane-beds/change-of-roughness.toml"
        printed = self.succeed("backwater", case).stdout
        self.assertLessEqual(max(map(len, printed.splitlines())), 80)
        self.assertIn("cobbles, from 2 m to 4 m", printed)
        told = json.loads(self.succeed("backwater", case, "--json", "-").stdout)
        self.assertEqual([reach["name"] for reach in told["reaches"]], ["", "cobbles"])
        # The reaches are those of channels of one bed, the upper one held by what goes on over the edge.
        below = json.loads(self.succeed("backwater", case, "--set", 'bed.equivalent_roughness="20 mm"', "--json", "-").stdout)
        self.assertAlmostEqual(told["stations"]["depth"][-40], below["stations"]["depth"][-40], delta=1e-6)
        self.assertAlmostEqual(told["reaches"][1]["normal_depth"], below["normal_depth"], delta=1e-9)
        # A given friction is that of the whole bed, and the patch is said to take no part.
        self.assertIn("patches take no", " ".join(self.succeed("backwater", case, "--manning", "0.015").stdout.split()))

    def test_backwater_prints_draws_and_writes_a_jump(self):
        jump = ["backwater", CASE, "--discharge", "20l/s", "--upstream", "20mm", "--downstream", "critical", "--length", "4"]
        files = {kind: self.folder / f"backwater.{kind}" for kind in ("json", "csv", "svg")}
        printed = self.succeed(*jump, "--json", files["json"], "--csv", files["csv"], "--figure", files["svg"]).stdout
        self.assertIn("hydraulic jump", printed)
        self.assertLessEqual(max(map(len, printed.splitlines())), 80)
        told = json.loads(files["json"].read_text())
        self.assertEqual([profile["name"] for profile in told["profiles"]], ["M3", "M2"])
        self.assertEqual(told["stations"]["x"][0], 0.0)
        self.assertEqual(told["stations"]["x"][-1], 4.0)
        self.assertEqual(told["stations"]["x"].count(told["jump"]["place"]), 2)
        self.assertAlmostEqual(told["stations"]["depth"][-1], told["critical_depth"], delta=1e-12)
        self.assertEqual(len(files["csv"].read_text().splitlines()) - 1, len(told["stations"]["x"]))
        xml.etree.ElementTree.parse(files["svg"])
        self.fail_with(2, *jump, "--csv", files["csv"], says=["exists"])
        self.assertEqual(len(self.succeed(*jump, "--csv", "-", "--stations", "5").stdout.splitlines()), 1 + 5 + 2)

    def test_backwater_says_what_cannot_be(self):
        for options, told in ((["--downstream", "10mm"], "below the critical depth"),
                              (["--upstream", "80mm"], "above the critical depth"),
                              (["--slope", "0"], "--length"), (["--discharge", "3kg"], "--discharge must be"),
                              (["--downstream", "deep"], "--downstream must be"),
                              (["--length", "5", "--slope", "-0.001"], "downstream"), (["--slope", "nan"], "from -1 to 1"),
                              (["--json", "-", "--csv", "-"], "same place")):
            with self.subTest(options=options):
                self.fail_with(2, "backwater", CASE, *options, says=[told])
        self.fail_with(2, "backwater", SOURCE / "cases/checks/poiseuille.toml", says=["no free surface"])

    CHANNEL = ["--set", "channel.dimensions=3", "--set", "channel.sides=half", "--set",
               "turbulence.closure=czernuszenko-rylov"]

    def test_section_prints_draws_and_writes_the_twin_of_a_channel_with_side_walls(self):
        table = self.succeed("section", CASE, *self.CHANNEL).stdout
        self.assertIn("weight carried by the side walls", table)
        files = {kind: self.folder / f"section.{kind}" for kind in ("json", "csv", "svg")}
        written = self.succeed("section", CASE, *self.CHANNEL, "--json", files["json"], "--csv", files["csv"],
                               "--figure", files["svg"], "--time", "1", "--from", "power-law")
        self.assertIn("within 1 % after", written.stdout)
        twin = json.loads(files["json"].read_text())
        self.assertAlmostEqual(twin["centreline_velocity"], 0.35, delta=0.035)
        self.assertAlmostEqual(twin["drag_share"] + twin["side_wall_share"], 1.0, delta=1e-10)
        self.assertAlmostEqual(twin["drag_share"], twin["partition"]["bed_share"], delta=1e-10)
        section = twin["transient"]["section"]
        cells = len(section["y"]) * len(section["z"])
        self.assertEqual(len(section["velocity"]), cells)
        self.assertEqual(len(files["csv"].read_text().splitlines()) - 1, cells)
        self.assertGreater(twin["transient"]["wall_layer_velocity"], twin["wall_layer_velocity"])
        xml.etree.ElementTree.parse(files["svg"])
        # What exists is not overwritten unasked, and a case without side walls has no section.
        self.fail_with(2, "section", CASE, *self.CHANNEL, "--csv", files["csv"], says=[str(files["csv"]), "--force"])
        self.fail_with(2, "section", CASE, says=["channel.sides", "riffle column"])

    def test_a_twin_that_does_not_apply_says_the_true_reason(self):
        checks = SOURCE / "cases/checks"
        for verb in ("column", "section"):
            self.fail_with(2, verb, checks / "flow-over-step.toml", says=["twin", '"step"'])
            self.fail_with(2, verb, checks / "dam-break.toml", says=["twin", "channel.ends"])
            self.fail_with(2, verb, checks / "standing-wave.toml", says=["twin", "channel.slope = 0"])

    def test_calibrate_writes_the_fitted_values_into_a_valid_case(self):
        case = self.folder / "fitted.toml"
        fitted = json.loads(self.succeed("calibrate", CASE, "--json").stdout)["parameters"]
        self.assertEqual([parameter["key"] for parameter in fitted], ["bed.drag_coefficient", "turbulence.lambda"])
        # The measured values of this case contradict each other, and the fit makes one worse: not without a word.
        self.fail_with(2, "calibrate", CASE, "--write", case, says=["worse", "--use", "--accept-worse"])
        self.assertFalse(case.exists())
        self.succeed("calibrate", CASE, "--write", case, "--accept-worse")
        written = tomllib.loads(case.read_text())
        for parameter in fitted:
            section, key = parameter["key"].split(".")
            self.assertAlmostEqual(written[section][key], parameter["value"], delta=1e-6)
        self.succeed("check", case)

    def test_schema_and_its_page_are_up_to_date(self):
        schema = json.loads(self.succeed("schema").stdout)
        self.assertIn("channel", schema["properties"])
        page = self.succeed("schema", "--markdown").stdout
        self.assertEqual(page, (SOURCE / "docs/case-reference.md").read_text(),
                         "docs/case-reference.md is stale: riffle schema --markdown -o docs/case-reference.md")

    def test_bench_measures(self):
        short = ["--seconds", "0.05", "--repetitions", "1"]
        measured = json.loads(self.succeed("bench", "channel-2d-5k", *short, "--json").stdout)
        for fact in ("version", "build", "processor", "instruction_set"):
            self.assertTrue(measured[fact], fact)
        self.assertEqual([w["scheme"] for w in measured["workloads"]], ["plain", "default"])
        for w in measured["workloads"]:
            self.assertEqual((w["name"], w["threads"], w["dimensions"]), ("channel-2d-5k", 1, 2))
            # A disc of 2h = 3 spacings holds 9 pi - 1 = 27 others; the surface lacks half of it, 50 rows deep.
            self.assertTrue(20 < w["neighbours"] < 28, w["neighbours"])
            # The rates are one measurement said in several ways.
            evaluation, pair = w["nanoseconds_per_particle_evaluation"], w["nanoseconds_per_directed_pair"]
            self.assertAlmostEqual(pair * w["neighbours"] / evaluation, 1, places=6)
            self.assertAlmostEqual(1e-9 * pair * w["directed_pairs_per_second_per_core"], 1, places=6)
            self.assertAlmostEqual(1e-9 * evaluation * w["particle_evaluations_per_second"], 1, places=6)
            operations = 51 if w["scheme"] == "plain" else 70
            self.assertAlmostEqual(w["useful_gigaflops_per_core"] * pair / operations, 1, places=6)
            # No arithmetic is faster than the fastest loop of nothing but arithmetic.
            self.assertTrue(0 < w["share_of_fma_peak"] < 1, w["share_of_fma_peak"])
            self.assertGreater(w["bytes_per_particle"], 2 * 16 + 8)  # position, velocity, density at least
            self.assertGreaterEqual(w["steps_per_list_build"], 1)
            self.assertAlmostEqual(w["skin_in_smoothing_lengths"], 0.3, places=6)  # "auto" in two dimensions
            self.assertEqual(set(w["phase_shares"]), {"lists", "gradients", "forces", "walls", "particles"})
            self.assertAlmostEqual(sum(w["phase_shares"].values()), 1, places=6)

    def test_bench_prints_tables_that_fit_a_terminal(self):
        text = self.succeed("bench", "channel-2d-5k/default", "--seconds", "0.05", "--repetitions", "1").stdout
        self.assertEqual(sum(line.startswith("channel-2d-5k/default") for line in text.splitlines()), 2)
        self.assertLessEqual(max(map(len, text.splitlines())), 110)

    def test_bench_refuses_what_it_cannot_run(self):
        self.fail_with(2, "bench", "channel-2d-5k/default", "no-such", says=["`no-such`", "channel-2d-5k/plain"])
        self.fail_with(2, "bench", "channel-2d-5k", "--all", says=["--all"])

    def test_bench_leaves_out_what_the_memory_does_not_hold(self):
        def limited(*arguments):
            return subprocess.run(["bash", "-c", 'ulimit -v 1000000 && exec "$@"', "bash", RIFFLE, *arguments],
                                  capture_output=True, text=True, timeout=240)

        if limited("version").returncode != 0:
            self.skipTest("this build needs more than 1 GB of address space for itself")
        result = limited("bench", "channel-3d-8m/plain")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("channel-3d-8m/plain is left out: it needs about", result.stderr)


if __name__ == "__main__":
    main()
