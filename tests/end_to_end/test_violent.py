"""Water that breaks: it comes to its end with the numerics for it, and what leaves the tank is accounted for."""
import re

from riffle_cli import SOURCE, CommandLineTest, every, main, until

CASE = SOURCE / "cases/violent/dam-break.toml"
# 450 particles.
COARSE = ["--set", "numerics.spacing=20mm", "--set", "output.standard_probes=false"]
# A tank with low walls, tilted, so that a part of the wave falls over the far one.
LOW = ["--set", "channel.wall_height=0.31", "--set", "channel.slope=0.3"]


def ledger(folder):
    import h5py

    with h5py.File(folder / "results.h5", "r") as file:
        rows = {name: data[:] for name, data in file["/lost_particles"].items()}
        return rows, dict(file["/summary"].attrs), file["/state/id"][:], file["/state/mass"][:]


class Violent(CommandLineTest):
    def gauges(self):
        """The case with gauges that the coarse step can serve."""
        case = self.folder / "dam.toml"
        case.write_text(CASE.read_text().replace("1500 Hz", "500 Hz"))
        return case

    def dam(self, name, seconds, *options):
        folder = self.folder / name
        self.succeed("run", self.gauges(), "-o", folder, "-q", "-j", 1, *COARSE, *until(seconds), *options)
        return folder

    def test_a_new_violent_case_runs_to_its_end(self):
        case = self.folder / "new.toml"
        self.succeed("new", "--violent", case)
        self.assertIn('preset = "violent"', case.read_text())
        case.write_text(case.read_text().replace("1500", "500"))
        said = self.succeed("check", case, *COARSE)
        self.assertNotIn("warning", said.stdout + said.stderr)
        folder = self.folder / "run"
        self.succeed("run", case, "-o", folder, "-q", *COARSE)
        rows, summary, ids, mass = ledger(folder)
        self.assertGreaterEqual(summary["simulated_time"], 3.0)
        self.assertEqual(len(rows["id"]), summary["lost_particles"])
        self.assertEqual([way for way in rows["exit"] if way >= 4], [], "water went through a wall or the bed")

    def test_check_advises_the_numerics(self):
        said = self.succeed("check", self.gauges(), *COARSE, "--set", "numerics.preset=riffle")
        self.assertIn('preset = "violent"', said.stdout + said.stderr)
        self.fail_with(2, "new", "--violent", "--from", "rough-bed", self.folder / "x.toml", says=["--from"])

    def test_the_default_numerics_come_to_the_end_too(self):
        # A spinning drop used to take the run with it (10 mm: at 0.64 s).
        folder = self.dam("default", 1.0, "--set", "numerics.preset=riffle", "--set", "numerics.spacing=10mm")
        self.assertGreaterEqual(ledger(folder)[1]["simulated_time"], 1.0)

    def test_what_leaves_stands_in_the_ledger(self):
        folder = self.dam("low", 1.5, *LOW, *every(snapshot=0.1))
        rows, summary, ids, mass = ledger(folder)
        count = len(rows["id"])
        self.assertGreater(count, 0)
        self.assertEqual(set(rows["exit"]), {1}, "all of it goes over the far wall")
        # Nobody is lost twice, and together they are all the water.
        self.assertEqual(sorted([*ids, *rows["id"]]), list(range(count + len(ids))))
        self.assertEqual(summary["lost_particles"], count)
        self.assertAlmostEqual(summary["lost_mass"], rows["mass"].sum(), places=9)
        self.assertAlmostEqual(summary["lost_share"], rows["mass"].sum() / (rows["mass"].sum() + mass.sum()), places=12)
        self.assertTrue((rows["position_x"] > 1.61).all())
        log = (folder / "run.log").read_text()
        self.assertEqual(len(re.findall("left over the far end wall and was taken out", log)), min(count, 10))
        self.assertIn("of the water)", log)
        said = self.succeed("report", folder)
        self.assertIn("Water that left the domain", (folder / "report.html").read_text())
        self.assertNotIn("Traceback", said.stderr)

    def test_a_resumed_run_has_the_same_ledger(self):
        straight = self.dam("straight", 1.4, *LOW, *every(snapshot=0.1))
        first = ledger(straight)[0]["time"][0]
        # Cut right after a loss, before the first one, and in between.
        for name, seconds in (("before", first - 0.01), ("after", first + 1e-6), ("later", first + 0.05)):
            parts = self.dam(name, seconds, *LOW, *every(snapshot=0.1))
            self.succeed("resume", parts, "-j", 2, "-q", *until(1.4))
            self.assert_same_results(straight, parts)


if __name__ == "__main__":
    main()
