"""Damaged files, full disks and runs that blow up: a clear message, and nothing good is lost."""
import os
import random
import shutil
import subprocess
import sys
import unittest

from riffle_cli import CASE, SMALL, CommandLineTest, contents, every, main, riffle, until


def in_own_mounts():
    """Whether this process may mount: as root, or in a user namespace of its own."""
    return os.environ.get("RIFFLE_TEST_MOUNTS") == "1"


class Damage(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.straight = self.run_small("straight", 0.4)
        self.half = self.run_small("half", 0.2)

    def recover_from_previous(self):
        self.succeed("resume", self.half, "--from", "checkpoint-previous.h5", "-j", 1, "-q", *until(0.4))
        self.assert_same_results(self.straight, self.half)

    def test_truncated_checkpoint(self):
        checkpoint = self.half / "checkpoint.h5"
        data = checkpoint.read_bytes()
        for length in (0, 100, 512, len(data) // 2, len(data) - 1):
            checkpoint.write_bytes(data[:length])
            self.fail_with(3, "resume", self.half, says=[str(checkpoint), "truncated", "--from checkpoint-previous.h5"])
        self.recover_from_previous()

    def test_one_flipped_bit_in_the_checkpoint(self):
        checkpoint = self.half / "checkpoint.h5"
        data = checkpoint.read_bytes()
        for position in (0, 700, len(data) // 3, len(data) // 2, len(data) - 1):
            damaged = bytearray(data)
            damaged[position] ^= 4
            checkpoint.write_bytes(damaged)
            self.fail_with(3, "resume", self.half, says=[str(checkpoint), "--from checkpoint-previous.h5"])
        self.recover_from_previous()

    def test_no_checkpoint_at_all_is_whole(self):
        for file in self.half.glob("checkpoint*"):
            file.write_bytes(file.read_bytes()[:-1])
        self.fail_with(3, "resume", self.half, says=["checkpoint.h5", "checkpoint-previous.h5", "riffle run"])

    def test_results_of_another_format_version(self):
        import h5py

        # As another program might write it: without a seal.
        with h5py.File(self.half / "results.h5") as file, h5py.File(self.folder / "other.h5", "w") as other:
            for name in file:
                file.copy(name, other)
            other.attrs.update(file.attrs)
            other.attrs["format_version"] = 99
        shutil.copy(self.folder / "other.h5", self.half / "results.h5")
        for command in (["report", self.half], ["resume", self.half, *until(0.4)]):
            self.fail_with(3, *command, says=[str(self.half / "results.h5"), "99", "version 1"])
        self.fail_with(3, "run", CASE, "-o", self.folder / "next", *SMALL, *until(0.1), "--set", "start.kind=results",
                       "--set", f'start.file="{self.half / "results.h5"}"', says=["99"])

    def test_damaged_results_never_become_a_report(self):
        whole = (self.half / "results.h5").read_bytes()
        generator = random.Random(1)
        for attempt in range(30):
            damaged = bytearray(whole)
            if attempt < 10:
                del damaged[len(damaged) * attempt // 10:]
            else:
                for _ in range(4):
                    damaged[generator.randrange(len(damaged))] ^= 1 << generator.randrange(8)
            (self.half / "results.h5").write_bytes(damaged)
            result = riffle("report", self.half, "-o", self.folder / "report.html")
            self.assertEqual(result.returncode, 3, f"attempt {attempt}: {result.stderr}")
            self.assertIn(str(self.half / "results.h5"), result.stderr)

    def test_a_run_that_blows_up_names_the_particle_and_keeps_the_checkpoint(self):
        folder = self.folder / "blow-up"
        shutil.copytree(self.half, folder)
        # 20 times the stable step, from a good state.
        result = self.fail_with(1, "resume", folder, *until(0.4), "--set", "numerics.time_step=0.006",
                                says=["particle", "at x =", "t = 0.2", "checkpoint", "riffle resume"])
        self.assertIn("--set numerics.time_step=0.003", result.stderr)
        self.assert_readable(folder)
        self.succeed("resume", folder, "-j", 1, "-q", *until(0.4), "--set", "numerics.time_step=auto")
        self.assert_same_results(self.straight, folder)

    def test_a_run_that_blows_up_at_once(self):
        folder = self.folder / "blow-up"
        self.fail_with(1, "run", CASE, "-o", folder, *SMALL, *until(0.4), "--set", "numerics.time_step=0.005",
                       says=["particle", "at x =", "t = 0", "checkpoint"])
        self.assert_readable(folder)
        self.assertIn("particle", (folder / "run.log").read_text())


@unittest.skipUnless(in_own_mounts(), "this system lets no test mount a file system (neither root nor user namespaces)")
class FullDisk(CommandLineTest):
    """On a file system in memory."""

    def mount(self, options):
        place = self.folder / "disk"
        place.mkdir()
        subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", place], check=True)
        self.addCleanup(subprocess.run, ["umount", "-l", place], check=False)
        return place

    def test_a_full_disk_loses_nothing(self):
        options = [*SMALL, *until(10), *every(checkpoint=0.02, snapshot=0.5)]
        straight = self.run_small("straight", 10, *every(checkpoint=0.02, snapshot=0.5))
        disk = self.mount("size=1100k")
        folder = disk / "run"
        self.fail_with(3, "run", CASE, "-o", folder, "-j", 1, *options,
                       says=[str(folder), "No space left on device", "untouched", "riffle resume"])
        self.assert_readable(folder)
        self.assertTrue(contents(folder / "checkpoint.h5"))
        # Still full: the same answer, and nothing is lost by asking.
        again = riffle("resume", folder, "-j", 1)
        self.assertEqual(again.returncode, 3, again.stderr)
        self.assert_readable(folder)
        subprocess.run(["mount", "-o", "remount,size=20m", disk], check=True)
        self.succeed("resume", folder, "-j", 1, "-q")
        self.assert_same_results(straight, folder)

    def test_a_disk_that_is_full_from_the_start(self):
        disk = self.mount("size=16k")
        self.fail_with(3, "run", CASE, "-o", disk / "run", *SMALL, *until(0.1),
                       says=[str(disk / "run"), "No space left on device"])
        with self.assertRaises(OSError), open(disk / "rest", "wb", buffering=0) as file:
            while True:
                file.write(bytes(512))
        self.fail_with(3, "new", disk / "case.toml", says=["case.toml", "space"])

    def test_a_disk_that_may_not_be_written(self):
        disk = self.mount("ro")
        self.fail_with(3, "run", CASE, "-o", disk / "run", *SMALL, *until(0.1), says=[str(disk), "Read-only"])


if __name__ == "__main__":
    if "RIFFLE_TEST_MOUNTS" not in os.environ:
        # Once more in a mount namespace of its own, whose mounts end with it.
        for unshare in (["unshare", "--mount"], ["unshare", "--map-root-user", "--mount"]):
            if shutil.which("unshare") and subprocess.run(
                    [*unshare, "sh", "-c", "mount -t tmpfs tmpfs /mnt"], capture_output=True, check=False).returncode == 0:
                environment = {**os.environ, "RIFFLE_TEST_MOUNTS": "1"}
                os.execvpe(unshare[0], [*unshare, sys.executable, *sys.argv], environment)
    main()
