"""Input that is wrong: every message says what, where, what was expected; nothing is left behind."""
import subprocess

from riffle_cli import CASE, RIFFLE, SMALL, CommandLineTest, kept_files, main, riffle, until


class BadInput(CommandLineTest):
    def refuse(self, setting, *says):
        target = self.folder / "run"
        self.fail_with(2, "run", CASE, "-o", target, "--set", setting, says=says)
        self.assertFalse(target.exists(), "a refused case leaves a folder behind")

    def test_values_given_with_set(self):
        self.refuse("channel.slop=0.1", "channel.slop", "unknown key `slop`", "did you mean `slope`?")
        self.refuse('channel.depth="50 s"', "channel.depth", "expected a length", "unit of a time")
        self.refuse("channel.depth=-0.05", "channel.depth", "-0.05", "greater than 0")
        self.refuse("channel.depth=nan", "channel.depth")
        self.refuse("numerics.spacing=20mm", "spacing is 20 mm", "roughness height 10 mm", "make the spacing")
        self.refuse("turbulence.closure=rampp", "turbulence.closure", 'did you mean "ramp"?')
        self.refuse("depth=1", "depth")
        self.refuse("channel.depth", "section.key=value")

    def test_case_file(self):
        case = self.folder / "flume.toml"
        text = CASE.read_text()

        def refuse(changed, *says):
            case.write_text(changed)
            self.fail_with(2, "check", case, says=[str(case), *says])

        line = 1 + text[:text.index("slope =")].count("\n")
        refuse(text.replace("slope =", "slop ="), f"flume.toml:{line}", "[channel]", "did you mean `slope`?")
        refuse(text.replace('depth = "50 mm"', 'depth = "50 s"'), "[channel]", "expected a length")
        refuse(text.replace("slope = 0.004", "slope = 0.004\nslope = 0.005"), "slope")
        refuse(text.replace("[channel]", "[chanel]"), "chanel", "did you mean")
        refuse("slope 0.004\n", "flume.toml:1", "key = value")
        refuse("", "[channel]")

    def test_lengths_in_metres_that_mean_millimetres(self):
        for setting, length in (("channel.depth=50", "depth is 50 m"), ("numerics.spacing=20um", "spacing is 20 um")):
            self.refuse(setting, length, "meant?", "--large", "particles")
            self.fail_with(2, "check", CASE, "--set", setting, says=[length, "--large"])

    def test_a_case_larger_than_the_memory(self):
        def limited(*arguments):
            return subprocess.run(["bash", "-c", 'ulimit -v 1500000 && exec "$@"', "bash", RIFFLE, *map(str, arguments)],
                                  capture_output=True, text=True, timeout=240)

        if limited("version").returncode != 0:
            self.skipTest("this build needs more than 1.5 GB of address space for itself")
        setting = ["--set", "channel.length=30", "--set", "channel.depth=0.7"]  # 5 million particles, nothing odd
        result = limited("run", CASE, "-o", self.folder / "run", *setting)
        self.assertEqual(result.returncode, 2, result.stderr)
        for words in ("particles of water", "GB are free", "--large"):
            self.assertIn(words, result.stderr)
        self.assertFalse((self.folder / "run").exists())

    def test_the_measured_profile_is_read_with_the_case(self):
        profile = self.folder / "profile.csv"
        setting = f'measured.velocity_profile="{profile}"'
        self.refuse(setting, "there is no such file")
        profile.write_text("z [mm], u [m/s]\n10, 0.2\n20, what\n")
        self.fail_with(3, "run", CASE, "-o", self.folder / "run", "--set", setting, says=["profile.csv:3", "what"])
        self.fail_with(3, "check", CASE, "--set", setting, says=["profile.csv:3"])
        profile.write_text("z [mm], u [m/s]\n10, 0.2\n200, 0.3\n")
        self.fail_with(3, "column", CASE, "--set", setting, says=["profile.csv:3", "within the water"])
        profile.write_text("z [mm], u [m/s]\n10, 0.2\n20, 0.3\n")
        self.succeed("check", CASE, "--set", setting)

    def test_what_a_file_holds_does_not_reach_the_terminal(self):
        case = self.folder / "flume.toml"
        case.write_text(CASE.read_text() + '\n["\\u001b[2J"]\nx = 1\n')
        self.fail_with(2, "check", case, says=["<U+001B>[2J"])
        self.fail_with(2, "check", CASE, "--set", "title=\x1b[2J", says=["U+001B"])
        self.fail_with(3, "check", "no\x1b[2Jsuch", says=["<U+001B>"])

    def test_nesting_without_end(self):
        case = self.folder / "flume.toml"
        case.write_text(CASE.read_text() + "a" + 50000 * ".a" + " = 1\n")
        line = case.read_text().count("\n")
        self.fail_with(2, "check", case, says=[f"flume.toml:{line}:", "parts"])

    def test_instruments(self):
        case = self.folder / "flume.toml"
        text = CASE.read_text()
        line = text.count("\n") + 1

        def refuse(kind, lines, *says):
            case.write_text(f'{text}[[probe]]\nname = "p"\nkind = "{kind}"\n{lines}')
            target = self.folder / "run"
            self.fail_with(2, "run", case, "-o", target, *SMALL, says=[f"flume.toml:{line}", "[[probe]]", *says])
            self.assertFalse(target.exists(), "a refused case leaves a folder behind")

        # The time step decides, and that of the small case is known before the run only.
        refuse("force", "sampling_frequency = 9e3\n", "sampling_frequency", "9000 Hz", "at most", "every second step")
        line += 4
        refuse("wave", 'sampling_frequency = "50 Hz"\nx = "1 m"\n', "x = 1 m is outside of the channel")
        refuse("grid", 'sampling_frequency = "50 Hz"\nspacing = "0.1 mm"\n', "too fine")

    def test_three_dimensions(self):
        case = self.space_case()

        def refuse(setting, *says):
            target = self.folder / "run"
            self.fail_with(2, "run", case, "-o", target, "--set", setting, says=says)
            self.assertFalse(target.exists(), "a refused case leaves a folder behind")

        refuse('output.snapshot_y=["50 mm", "60 mm"]', "snapshot_y", "no water from 50 mm to 60 mm", "43.3013 mm")
        refuse('output.snapshot_z=["20 mm", "10 mm"]', "snapshot_z", "the first one smaller")
        refuse('output.snapshot_fields="velocity speed"', "snapshot_fields", '"speed"', "eddy_viscosity")
        refuse('output.mean_field_spacing=0', "mean_field_spacing", "greater than 0")
        case.write_text(case.read_text() + '[[probe]]\nname = "p"\nkind = "velocity"\nsampling_frequency = "50 Hz"\n'
                        'x = "10 mm"\ny = "50 mm"\nz = "20 mm"\n')
        refuse("start.jitter=0.2", "[[probe]]", "y = 50 mm is outside of the simulated channel", "43.3013 mm")
        self.fail_with(2, "check", CASE, "--set", "output.mean_field_spacing=0.01", says=["mean_field_spacing"])

    def test_damaged_case_files_never_crash_the_command(self):
        text = CASE.read_bytes()
        case = self.folder / "damaged.toml"
        for step in range(0, len(text), max(1, len(text) // 40)):
            for damaged in (text[:step], text[:step] + b"\xff\x00[" + text[step + 1:]):
                case.write_bytes(damaged)
                result = riffle("column", case)
                self.assertIn(result.returncode, (0, 2), f"cut at {step}: {result.stderr}")

    def test_missing_and_unreadable_files(self):
        missing = self.folder / "missing.toml"
        self.fail_with(3, "run", missing, says=[str(missing), "no such case file"])
        self.fail_with(3, "check", self.folder, says=[str(self.folder)])
        self.fail_with(3, "report", self.folder / "nowhere", says=["nowhere", "no such file or folder"])
        self.fail_with(3, "report", self.folder, says=[str(self.folder)])
        self.fail_with(3, "resume", self.folder / "nowhere", says=["nowhere", "no run to resume", "riffle run"])

    def test_output_folder_below_a_file(self):
        blocker = self.folder / "file"
        blocker.write_text("")
        self.fail_with(3, "run", CASE, "-o", blocker / "run", *SMALL, *until(0.1),
                       says=[str(blocker / "run"), "Not a directory", "-o"])

    def test_results_are_not_overwritten_without_force(self):
        folder = self.run_small("run", 0.05)
        before = kept_files(folder)
        self.fail_with(3, "run", CASE, "-o", folder, *SMALL, *until(0.05),
                       says=[str(folder), "already holds results", "riffle resume", "--force"])
        self.assertEqual(before, kept_files(folder))
        self.run_small("run", 0.1, "--force")
        self.fail_with(2, "run", CASE, "-o", "", says=["-o", "empty"])

    def test_resume_changes_only_what_leaves_the_state_valid(self):
        folder = self.run_small("run", 0.05)
        self.fail_with(2, "resume", folder, "--set", "channel.depth=0.06", says=["channel.depth", "new run"])
        self.fail_with(2, "resume", folder, "--set", "run.untl=1", says=["run.untl", "did you mean `until`?"])


if __name__ == "__main__":
    main()
