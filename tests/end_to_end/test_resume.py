"""A run that is stopped, by the user, a signal or a crash, and resumed equals the one that was not, bit by bit."""
import os
import random
import shutil
import signal
import time

from riffle_cli import CASE, SMALL, CommandLineTest, contents, every, main, riffle, start, until, wait_for

# Long enough to be hit in the middle, with a checkpoint as often as the solver grants one.
SECONDS = 10
OFTEN = every(checkpoint=0.02, snapshot=1)


class Resume(CommandLineTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        seed = int(os.environ.get("RIFFLE_TEST_SEED", random.SystemRandom().randrange(10**6)))
        print(f"moments drawn with RIFFLE_TEST_SEED={seed}", flush=True)
        cls.random = random.Random(seed)

    def command(self, folder):
        return ["run", CASE, "-o", folder, "-j", 1, *SMALL, *until(SECONDS), *OFTEN]

    def test_a_run_in_two_parts_equals_one(self):
        # The cut falls into an averaging window of the grid among the instruments.
        options = every(snapshot=0.1)
        case = self.case_with_probes()
        straight = self.run_small("straight", 0.4, *options, case=case)
        parts = self.run_small("parts", 0.2, *options, case=case)
        self.succeed("resume", parts, "-j", 2, "-q", *until(0.4))
        self.assert_same_results(straight, parts)
        self.fail_with(2, "resume", parts, "--set", "output.standard_probes=false", says=["output.standard_probes"])

    def test_a_run_in_three_dimensions_in_two_parts_equals_one(self):
        # The cut falls into a window of the mean field.
        options = every(snapshot=0.1)
        case = self.space_case_with_probes()
        straight = self.run_space("straight", 0.4, *options, case=case)
        parts = self.run_space("parts", 0.2, *options, case=case)
        self.fail_with(2, "resume", parts, "--set", "output.mean_field_spacing=0.01", says=["output.mean_field_spacing"])
        self.succeed("resume", parts, "-j", 2, "-q", *until(0.4))
        self.assert_same_results(straight, parts)
        for index in ("results.xdmf", "mean_field.xdmf"):
            self.assertEqual((straight / index).read_bytes(), (parts / index).read_bytes())

    def test_a_run_in_three_dimensions_that_is_killed_can_be_resumed(self):
        straight = self.run_space("straight", 4.0)
        folder = self.folder / "killed"
        process = start("run", self.space_case(), "-o", folder, "-j", 1, *until(4.0), *every(checkpoint=0.02))
        wait_for((folder / "checkpoint-previous.h5").exists, "the second checkpoint")
        time.sleep(self.random.uniform(0.0, 0.3))
        process.kill()
        process.communicate()
        self.assertNotEqual(process.returncode, 0, "the run ended before it could be killed")
        self.succeed("resume", folder, "-j", 1, "-q", "--set", "output.checkpoint_interval=60")
        self.assert_same_results(straight, folder, leave_out=["/case/text"])

    def test_resume_of_a_complete_run_changes_nothing(self):
        folder = self.run_small("run", 0.2)
        copy = shutil.copytree(folder, self.folder / "copy")
        self.succeed("resume", folder, "-q")
        self.assert_same_results(folder, copy)

    def test_stop_signals_leave_a_checkpoint_and_their_exit_status(self):
        straight = self.run_small("straight", SECONDS, *OFTEN)
        for number, sent in enumerate((signal.SIGINT, signal.SIGTERM)):
            with self.subTest(signal=sent.name):
                folder = self.folder / sent.name
                process = start(*self.command(folder))
                wait_for((folder / "checkpoint.h5").exists, "the first checkpoint")
                time.sleep(self.random.uniform(0.0, 0.5))
                process.send_signal(sent)
                output, errors = process.communicate(timeout=60)
                self.assertEqual(process.returncode, 128 + sent, errors)
                self.assertIn(f"riffle resume {folder}", output)
                self.assert_readable(folder)
                self.succeed("resume", folder, "-j", 1 + number, "-q")
                self.assert_same_results(straight, folder)

    def test_killed_again_and_again_it_still_ends_the_same(self):
        straight = self.run_small("straight", SECONDS, *OFTEN)
        folder = self.folder / "killed"
        process = start(*self.command(folder))
        wait_for((folder / "checkpoint.h5").exists, "the first checkpoint")
        kills = 0
        for _ in range(12):
            time.sleep(self.random.uniform(0.0, 0.4))
            process.kill()
            process.communicate()
            if process.returncode == 0:
                break
            kills += 1
            self.assert_readable(folder)
            process = start("resume", folder, "-j", 1)
        _, errors = process.communicate(timeout=240)
        self.assertEqual(process.returncode, 0, errors)
        self.assertGreater(kills, 0, "the run ended before it could be killed")
        self.assertEqual([file.name for file in folder.glob("*.new")], [], "a half-written file is left")
        self.assert_same_results(straight, folder)

    def test_killed_before_the_first_checkpoint(self):
        straight = self.run_small("straight", 0.1)
        states = set()
        for attempt in range(20):
            folder = self.folder / f"killed-{attempt}"
            process = start("run", CASE, "-o", folder, *SMALL, *until(30))
            time.sleep(0.002 * attempt)
            process.kill()
            process.communicate()
            names = {file.name for file in folder.iterdir()} if folder.exists() else set()
            states.add("checkpoint.h5" in names)
            if "results.h5" in names:
                contents(folder / "results.h5")
            if "checkpoint.h5" not in names:
                self.fail_with(3, "resume", folder, says=[str(folder), "riffle run"])
                self.succeed("run", CASE, "-o", folder, "-j", 1, "--force", "-q", *SMALL, *until(0.1))
                self.assert_same_results(straight, folder)
        self.assertIn(False, states, "the command was never killed early enough")

    def test_results_without_any_checkpoint(self):
        folder = self.run_small("run", 0.1)
        for file in folder.glob("checkpoint*"):
            file.unlink()
        self.fail_with(3, "resume", folder, says=["checkpoint does not exist", f"-o {folder} --force"])
        self.assertEqual(riffle("report", folder).returncode, 0)

    def test_checkpoint_without_results(self):
        folder = self.run_small("run", 0.1)
        (folder / "results.h5").unlink()
        self.fail_with(3, "resume", folder, says=["results.h5"])


if __name__ == "__main__":
    main()
