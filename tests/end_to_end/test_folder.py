"""The folder of a run: one process at a time, files that belong together, what a failure leaves, where output goes."""
import json
import os
import shutil
import signal
import subprocess
import time

from riffle_cli import CASE, RIFFLE, SMALL, CommandLineTest, contents, every, main, riffle, start, text, until, wait_for

OFTEN = every(checkpoint=0.02)


def state_of(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.name not in ("run.log", ".run.lock")}


class OneProcess(CommandLineTest):
    def begin(self, folder, *command):
        process = start(*(command or ["run", CASE, "-o", folder, "-j", 1, "-q", *SMALL, *until(10000), *OFTEN]))
        self.addCleanup(lambda: (process.kill(), process.communicate()))
        wait_for((folder / "checkpoint-previous.h5").exists, "the second checkpoint")
        return process

    def test_a_folder_in_use_is_refused_with_the_process(self):
        folder = self.folder / "run"
        first = self.begin(folder)
        says = [f"process {first.pid}", str(folder), "riffle watch", f"kill {first.pid}"]
        self.fail_with(3, "run", CASE, "-o", folder, *SMALL, *until(0.1), says=says)
        self.fail_with(3, "run", CASE, "-o", folder, *SMALL, *until(0.1), "--force", says=says)
        self.fail_with(3, "resume", folder, says=says)
        self.assertIsNone(first.poll())
        # Reading goes on, and says that it is not the end.
        report = self.succeed("report", folder)
        self.assertIn(f"process {first.pid}", report.stderr)
        self.succeed("verify", folder)
        first.send_signal(signal.SIGTERM)
        first.communicate(timeout=60)
        self.succeed("resume", folder, "-q", "-j", 1, *until(0.01))

    def test_the_lock_of_a_killed_run_is_gone(self):
        folder = self.folder / "run"
        first = self.begin(folder)
        first.kill()
        first.communicate()
        self.succeed("resume", folder, "-q", "-j", 1, *until(0.01))

    def test_a_run_whose_folder_was_moved_leaves_that_of_the_next_run_alone(self):
        folder = self.folder / "run"
        first = self.begin(folder, "run", CASE, "-o", folder, "-j", 1, *SMALL, *until(10000), *OFTEN)
        folder.rename(self.folder / "moved")
        second = self.begin(folder)
        errors = first.communicate(timeout=60)[1]
        self.assertEqual(first.returncode, 3, errors)
        # It may be in the middle of writing.
        self.assertRegex(errors, "was removed or moved while the run went on|cannot be written: No such file")
        self.assertIsNone(second.poll())
        second.send_signal(signal.SIGTERM)
        second.communicate(timeout=60)
        self.succeed("verify", folder)

    def test_of_many_that_start_at_once_one_runs(self):
        folder = self.folder / "run"
        processes = [start("run", CASE, "-o", folder, "-j", 1, "-q", *SMALL, *until(0.3)) for _ in range(6)]
        errors = [process.communicate(timeout=120)[1] for process in processes]
        ended = [process.returncode for process in processes]
        self.assertEqual(sorted(ended), [0, 3, 3, 3, 3, 3], errors)
        self.assert_same_results(self.run_small("alone", 0.3), folder)


class Ties(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.run = self.run_small("run", 0.2)
        self.straight = self.run_small("straight", 0.4)

    def refused(self, *command, status=3, says=()):
        before = state_of(self.run)
        self.fail_with(status, *command, says=says)
        self.assertEqual(state_of(self.run), before, "a command that was refused has changed something")

    def test_a_checkpoint_of_another_run_is_refused(self):
        # As many particles, another slope; and one of another size.
        for name, options in (("slope", ["--set", "channel.slope=0.003"]), ("size", ["--set", "channel.length=0.09"])):
            other = self.run_small(name, 0.2, *options)
            for file in ("checkpoint.h5", "elsewhere.h5"):
                with self.subTest(name=name, file=file):
                    kept = (self.run / "checkpoint.h5").read_bytes()
                    shutil.copy(other / "checkpoint.h5", self.run / file)
                    self.refused("resume", self.run, *until(0.4), "--from", file, says=["another run", "--force"])
                    (self.run / "checkpoint.h5").write_bytes(kept)
                    (self.run / "elsewhere.h5").unlink(missing_ok=True)

    def test_advice_about_a_checkpoint_harms_nothing(self):
        other = self.run_small("other", 0.2)
        for file in ("nothing.h5", other / "checkpoint.h5"):
            error = self.fail_with(3, "resume", self.run, *until(0.4), "--from", file, says=["riffle resume"]).stderr
            self.assertNotIn("--force", error)

    def test_results_that_end_before_the_checkpoint_are_refused(self):
        earlier = self.run_small("earlier", 0.1)
        shutil.copytree(earlier, self.folder / "copy")
        self.succeed("resume", earlier, "-q", "-j", 1, *until(0.2))
        shutil.copy(self.folder / "copy/results.h5", earlier / "results.h5")
        self.run = earlier
        self.refused("resume", earlier, *until(0.4), says=["results.h5", "older than the checkpoint"])

    def test_resume_from_the_previous_checkpoint_killed_at_once_can_be_resumed(self):
        # Both checkpoints lie apart; the results reach the newest.
        self.succeed("resume", self.run, "-q", "-j", 1, *until(0.3))
        self.assertNotEqual((self.run / "checkpoint.h5").read_bytes(), (self.run / "checkpoint-previous.h5").read_bytes())
        for delay in (0.0, 0.02, 0.05, 0.1, 0.2):
            process = start("resume", self.run, "-q", "-j", 1, "--from", "checkpoint-previous.h5", *until(0.4))
            time.sleep(delay)
            process.kill()
            process.communicate()
            contents(self.run / "results.h5")
            copy = self.folder / f"copy-{delay}"
            shutil.copytree(self.run, copy)
            self.succeed("resume", copy, "-q", "-j", 1, *until(0.4))
            self.assert_same_results(self.straight, copy)

    def test_the_first_write_of_a_resume_takes_the_mark_of_the_end_away(self):
        import h5py

        process = start("resume", self.run, "-q", "-j", 1, *until(10000), "--set", "output.checkpoint_interval=1000")
        self.addCleanup(lambda: (process.kill(), process.communicate()))
        wait_for(lambda: "resumed at" in (self.run / "run.log").read_text(), "the resume")
        with h5py.File(self.run / "results.h5") as file:
            self.assertEqual(file.attrs["complete"], 0)
            self.assertNotIn("position_x", file["state"])

    def test_inputs_that_have_changed(self):
        stl = self.folder / "box.stl"
        stl.write_text(box_stl(0.02))
        case = self.space_case()
        case.write_text(case.read_text().replace("[start]", '[start]\nkind = "rest"') +
                        f'[[solid]]\nname = "box"\nfile = "{stl}"\nscale = "1 mm"\nplace = ["15 mm", "12 mm", "20 mm"]\n')
        folder = self.folder / "solid"
        result = riffle("run", case, "-o", folder, "-j", 1, "-q", *until(0.02))
        self.assertEqual(result.returncode, 0, result.stderr)
        self.run = folder
        stl.write_text(box_stl(0.015))
        self.refused("resume", folder, *until(0.04), status=2, says=["box.stl", "solid", "new run"])
        stl.write_text(box_stl(0.02))
        self.succeed("resume", folder, "-q", "-j", 1, *until(0.04))

    def test_a_start_file_that_has_changed_is_told(self):
        folder = self.folder / "next"
        self.succeed("run", CASE, "-o", folder, "-q", "-j", 1, *SMALL, *until(0.1), "--set", "start.kind=results", "--set",
                     f'start.file="{self.run / "results.h5"}"')
        self.succeed("resume", self.run, "-q", "-j", 1, *until(0.25))
        result = self.succeed("resume", folder, "-j", 1, *until(0.15))
        self.assertIn("start.file", result.stderr)
        self.assertIn("start.file", (folder / "run.log").read_text())

    def test_other_instructions_are_told(self):
        result = self.succeed("resume", self.run, "-j", 1, *until(0.25), env={**os.environ, "RIFFLE_INSTRUCTION_SET": "baseline"})
        self.assertIn("instruction set", result.stderr)
        self.assertIn("instruction set", (self.run / "run.log").read_text())
        self.assertNotIn("instruction set", self.succeed("resume", self.straight, "-j", 1).stderr)

    def test_shortened_arrays_to_start_from(self):
        import h5py

        with h5py.File(self.run / "results.h5", "r+") as file:
            short = file["state/velocity_x"][:-5]
            del file["state/velocity_x"]
            file["state/velocity_x"] = short
        self.succeed("verify", "--accept", self.run / "results.h5")
        self.fail_with(2, "run", CASE, "-o", self.folder / "next", *SMALL, *until(0.1), "--set", "start.kind=results", "--set",
                       f'start.file="{self.run / "results.h5"}"', says=["velocity_x", "altered"])

    def test_force_keeps_everything_until_the_new_run_begins(self):
        for more in (["--set", "numerics.spacing=50mm"], ["--set", "start.kind=results", "--set", 'start.file="nowhere.h5"']):
            self.refused("run", CASE, "-o", self.run, "--force", *SMALL, *until(0.1), *more, status=2)
        self.succeed("run", CASE, "-o", self.run, "--force", "-q", "-j", 1, *SMALL, *until(0.4))
        self.assert_same_results(self.straight, self.run)


class Failures(CommandLineTest):
    def test_a_failure_keeps_all_rows_and_the_moment(self):
        import h5py
        import numpy as np

        folder = self.folder / "fails"
        result = self.fail_with(1, "run", CASE, "-o", folder, "-j", 1, *SMALL, *until(0.4), "--set", "numerics.time_step=0.001",
                                *every(series=0.001), says=["failure.h5", "up to the failure", "checkpoint is at t = 0 s"])
        failed_at = float(result.stderr.split("at t = ")[1].split(" s")[0])
        with h5py.File(folder / "results.h5") as file:
            self.assertGreater(file["time_series/time"][-1], failed_at - 0.002)
            self.assertIn("particle", text(file.attrs["failure"]))
            self.assertEqual(file.attrs["complete"], 0)
        with h5py.File(folder / "failure.h5") as file:
            around = file["neighbourhood"]
            self.assertEqual(around["id"][0], file.attrs["particle"])
            # The particle itself and the 50 nearest, by where those were last that are nowhere now.
            self.assertEqual(len(around["id"]), 51)
            self.assertTrue(np.isfinite(around["distance"][:]).all())
            # It is the one that departs most of those that are not finite: there the failure began.
            places, velocity = file["snapshots/00000/position"][:], file["snapshots/00000/velocity"][:]
            density, first = file["snapshots/00000/density"][:], file["snapshots/00000/id"][:] == file.attrs["particle"]
            lost = ~(np.isfinite(places).all(axis=1) & np.isfinite(velocity).all(axis=1) & np.isfinite(density))
            departure = np.where(np.isfinite(density), abs(density - 1000), np.inf)
            self.assertTrue(lost[first][0])
            self.assertEqual(departure[first][0], departure[lost].max())
            self.assertEqual(sorted(around["distance"][:]), list(around["distance"][:]))
            self.assertEqual(file["snapshots/00000/position"].shape[1], 3)
        log = (folder / "run.log").read_text()
        self.assertIn("neighbours", log)
        self.assertIn("error", log)
        self.succeed("report", folder)
        verdict = json.loads((folder / "summary.json").read_text())["verdict"]
        self.assertEqual(verdict["status"], "bad")
        self.assertIn("The run failed", verdict["headline"])
        self.assertIn("particle", " ".join(verdict["sentences"]))
        # The next one that goes well leaves no trace of it.
        self.succeed("resume", folder, "-q", "-j", 1, *until(0.4), "--set", "numerics.time_step=auto")
        self.assertFalse((folder / "failure.h5").exists())
        with h5py.File(folder / "results.h5") as file:
            self.assertEqual(text(file.attrs["failure"]), "")

    def test_signals_of_batch_systems_leave_a_checkpoint(self):
        for sent in (signal.SIGHUP, signal.SIGXCPU, signal.SIGUSR1, signal.SIGUSR2):
            with self.subTest(signal=sent.name):
                folder = self.folder / sent.name
                process = start("run", CASE, "-o", folder, "-j", 1, *SMALL, *until(10000))
                wait_for((folder / "checkpoint.h5").exists, "the first checkpoint")
                process.send_signal(sent)
                output, errors = process.communicate(timeout=60)
                self.assertEqual(process.returncode, 128 + sent, errors)
                self.assertIn(f"riffle resume {folder}", output)
                self.assertIn("stopped at", (folder / "run.log").read_text())

    def test_nohup_outlives_its_terminal(self):
        folder = self.folder / "run"
        process = subprocess.Popen(["nohup", RIFFLE, "run", CASE, "-o", folder, "-j", "1", "-q", *SMALL, *until(0.3)],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_for((folder / "checkpoint.h5").exists, "the first checkpoint")
        process.send_signal(signal.SIGHUP)
        self.assertEqual(process.wait(timeout=60), 0)

    def test_a_limit_of_the_size_of_files_is_told(self):
        folder = self.folder / "run"
        result = subprocess.run(["sh", "-c", 'ulimit -f 300; exec "$@"', "sh", RIFFLE, "run", CASE, "-o", folder, "-j", "1", "-q",
                                 *SMALL, *until(5), *every(snapshot=0.05, checkpoint=0.05)], capture_output=True, text=True,
                                timeout=120, check=False)
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("ulimit -f", result.stderr)
        self.assertIn("ulimit -f", (folder / "run.log").read_text())
        self.succeed("verify", folder)
        self.succeed("resume", folder, "-q", "-j", 1, *until(0.01))

    def test_a_reader_of_the_progress_that_goes_away_ends_nothing(self):
        folder = self.folder / "run"
        command = f"{RIFFLE} run {CASE} -o {folder} -j 1 {' '.join(map(repr, [*SMALL, *until(1), *every(progress=0.01)]))} 2>&1"
        subprocess.run(["bash", "-c", f"{command} >/dev/null | true"], timeout=120, check=False)
        wait_for(lambda: "finished at" in (folder / "run.log").read_text(), "the end of the run")


class Outputs(CommandLineTest):
    def test_full_standard_output_is_an_error(self):
        with open("/dev/full", "w") as full:
            for command in (["check", CASE, *SMALL], ["column", CASE], ["schema"], ["version"]):
                result = subprocess.run([RIFFLE, *map(str, command)], stdout=full, stderr=subprocess.PIPE, text=True, timeout=120,
                                        check=False)
                self.assertEqual(result.returncode, 3, command)
                self.assertIn("No space left on device", result.stderr)

    def test_devices_and_links_stay(self):
        folder = self.run_small("run", 0.1)
        before = os.stat("/dev/null")
        self.succeed("report", folder, "-o", "/dev/null")
        self.assertFalse(os.path.exists("/dev/null-summary.json"))
        self.succeed("report", folder, "-o", "/dev/null", "--json", "/dev/null")
        after = os.stat("/dev/null")
        self.assertEqual((before.st_mode, before.st_rdev, before.st_ino), (after.st_mode, after.st_rdev, after.st_ino))
        (self.folder / "pages").mkdir()
        page = self.folder / "page.html"
        page.symlink_to("pages/real.html")
        self.succeed("report", folder, "-o", page)
        self.assertTrue(page.is_symlink())
        self.assertIn("</html>", (self.folder / "pages/real.html").read_text())
        # Results behind a link stay there.
        (self.folder / "disk").mkdir()
        shutil.move(folder / "results.h5", self.folder / "disk/results.h5")
        (folder / "results.h5").symlink_to(self.folder / "disk/results.h5")
        self.succeed("resume", folder, "-q", "-j", 1, *until(0.2))
        self.assertTrue((folder / "results.h5").is_symlink())
        self.assert_same_results(self.run_small("straight", 0.2), folder)


class Verify(CommandLineTest):
    def test_names_what_is_whole_and_what_is_not(self):
        folder = self.run_small("run", 0.1)
        result = self.succeed("verify", folder)
        self.assertEqual([line.split(": ")[1].split(",")[0] for line in result.stdout.splitlines()], ["whole"] * 3)
        data = bytearray((folder / "results.h5").read_bytes())
        data[len(data) // 2] ^= 1
        (folder / "results.h5").write_bytes(data)
        result = self.fail_with(3, "verify", folder, says=["of its pages of 64 KiB", "Lost: "])
        self.assertIn("checkpoint.h5: whole", result.stdout)

    def test_tells_of_bytes_behind_the_end(self):
        folder = self.run_small("run", 0.1)
        with open(folder / "results.h5", "ab") as file:
            file.write(b"x" * 100)
        self.assertIn("results.h5: whole, but for 100 bytes behind the end", self.succeed("verify", folder).stdout)
        self.succeed("resume", folder, "-q", "-j", 1, *until(0.2))
        self.assertIn("results.h5: whole\n", self.succeed("verify", folder).stdout)

    def test_accepts_a_change_that_was_meant(self):
        import h5py

        folder = self.run_small("run", 0.1)
        with h5py.File(folder / "results.h5", "r+") as file:
            file.attrs["title"] = "another title"
        self.fail_with(3, "report", folder, says=["results.h5"])
        self.succeed("verify", "--accept", folder)
        self.succeed("report", folder)
        self.succeed("resume", folder, "-q", "-j", 1, *until(0.2))


def box_stl(size):
    """A closed box as STL text, mm."""
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    faces = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4),
             (1, 5, 7), (1, 7, 3)]
    lines = ["solid box"]
    for face in faces:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex " + " ".join(f"{1000 * size * value:.6g}" for value in corners[corner]) for corner in face]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid box"]) + "\n"


if __name__ == "__main__":
    main()
