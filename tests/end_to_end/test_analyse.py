"""`riffle analyse` on a short run and on the examples of laboratory data."""
import csv
import json
import math

from riffle_cli import CASE, SMALL, SOURCE, CommandLineTest, every, main, until

LABORATORY = SOURCE / "cases/laboratory"
CHAPTERS = {"statistics", "profiles", "fits", "surface", "subsurface", "forces", "energy"}


class Analyse(CommandLineTest):
    def short_run(self, name="run"):
        folder = self.folder / name
        self.succeed("run", CASE, "-o", folder, "-q", *SMALL, *until(3), "--set", "run.average_from=1",
                     *every(surface=0.01))
        return folder

    def analysed(self, *arguments):
        target = self.folder / "analysis.json"
        self.succeed("analyse", *arguments, "--json", target)
        document = json.loads(target.read_text())
        self.assertEqual(document["format"], "riffle-analysis")
        return document["analyses"]

    def test_a_run_gives_findings_and_figures_of_each_chapter(self):
        folder = self.short_run()
        csv_folder = self.folder / "csv"
        printed = self.succeed("analyse", folder, "--csv", csv_folder).stdout
        for words in ("depth-mean velocity above the datum", "Free surface", "measured (thesis, Table 3.1)"):
            self.assertIn(words, printed)
        analysis = self.analysed(folder)[0]
        self.assertEqual({finding["chapter"] for finding in analysis["findings"]}, CHAPTERS)
        drawn = {figure["key"] for figure in analysis["figures"] if not figure["missing"]}
        for key in ("velocity_profile", "stress_profile", "log_law", "surface_map", "force_history",
                    "velocity_spectrum", "surface_cross_correlation"):
            self.assertIn(key, drawn)
        for figure in analysis["figures"]:
            for curve in figure["curves"]:
                self.assertEqual(len(curve["x"]), len(curve["y"]), figure["key"])
        files = {path.stem for path in csv_folder.glob("*.csv")}
        self.assertLessEqual({"findings", "velocity_profile", "surface_map_map"}, files)
        with open(csv_folder / "findings.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["key"] for row in rows], [finding["key"] for finding in analysis["findings"]])
        with open(csv_folder / "velocity_profile.csv", newline="") as file:
            heading = next(line for line in file if not line.startswith("#"))
        self.assertIn("streamwise velocity u [m/s],height above the bed level z [m]", heading)

    def test_free_bodies_stand_in_figures_where_the_water_has_taken_them(self):
        folder = self.folder / "roll"
        self.succeed("run", SOURCE / "cases/bodies/rolling-box.toml", "-o", folder, "-q", "--set", "numerics.spacing=20mm", *until(0.4))
        figures = self.analysed(folder)[0]["figures"]
        box = next(curve for figure in figures if figure["key"] == "level_lines" for curve in figure["curves"] if curve["name"] == "box")
        corners = [complex(x, y) for x, y in zip(box["x"], box["y"])][:4]
        # It turns about its middle from ten degrees towards its rest, level; its sides keep their lengths.
        self.assertAlmostEqual(abs(sum(corners) / 4 - complex(1.5, 0.45)), 0, delta=1e-6)
        sides = sorted((corners[1] - corners[0], corners[2] - corners[1]), key=abs)
        self.assertAlmostEqual(abs(sides[0]), 0.1, delta=1e-6)
        self.assertAlmostEqual(abs(sides[1]), 0.3, delta=1e-6)
        turned = abs(math.degrees(math.atan(sides[1].imag / sides[1].real)))
        self.assertLess(turned, 9)
        self.assertGreater(turned, 1)

    def test_a_users_table_is_refused_before_the_analysis_begins(self):
        folder = self.run_small("run", 0.3)
        # The second input cannot be read: that the table is told of instead shows that nothing has been read yet.
        bad = self.folder / "bad.csv"
        bad.write_text("z,u\n0.01,0.2\n0.02,fast\n")
        tables = self.folder / "tables"
        for name in ("findings.csv", "1/velocity_history.csv", "2/velocity_profile.csv", "1/mean_velocity_map_map_2.csv"):
            mine = tables / name
            mine.parent.mkdir(parents=True, exist_ok=True)
            for text in ("# my flume\nz,u\n", "z,u\n"):
                mine.write_text(text)
                result = self.fail_with(2, "analyse", folder, bad, "--csv", tables, says=["would be lost", str(mine)])
                self.assertEqual(result.stdout, "")
                self.assertEqual(mine.read_text(), text)
            mine.unlink()
        # Beside the tables a user's own may stand, also under a name that another chapter has, or none.
        tables = self.folder / "forces"
        tables.mkdir()
        others = [tables / name for name in ("velocity_profile.csv", "my-profile.csv", "force_history_map_of_mine.csv")]
        for other in others:
            other.write_text("z,u\n")
        for _ in range(2):  # and older tables are replaced
            self.succeed("analyse", folder, "--chapter", "forces", "--csv", tables)
        self.assertTrue((tables / "force_history.csv").read_text().startswith("# Forces on the water\n"))
        self.assertEqual([other.read_text() for other in others], ["z,u\n"] * 3)

    def velocity_profile(self, *arguments):
        figures = {figure["key"]: figure for figure in self.analysed(*arguments)[0]["figures"]}
        return figures["velocity_profile"]["curves"][0]["x"]

    def test_a_window_averages_anew(self):
        folder = self.short_run()
        values = {window: self.velocity_profile(folder, "--window", window) for window in ("1,2", "2,3")}
        # The window of the run itself gives the profile that the run has written.
        self.assertEqual(self.velocity_profile(folder, "--window", "1,3"), self.velocity_profile(folder))
        self.assertEqual(len(values["1,2"]), len(values["2,3"]))
        self.assertNotEqual(values["1,2"], values["2,3"])

    def test_laboratory_records_pass_through_the_same_chapters(self):
        case = ["--case", CASE]
        waves = self.analysed(LABORATORY / "wave-probes.csv", *case)[0]
        keys = {finding["key"]: finding["value"] for finding in waves["findings"]}
        self.assertAlmostEqual(keys["celerity_between_places_1"], 0.36, delta=0.01)
        profile = self.analysed(LABORATORY / "adv-profile.csv", *case)[0]
        self.assertIn("log_law", {figure["key"] for figure in profile["figures"]})

    def test_a_run_beside_a_laboratory_record(self):
        folder = self.short_run()
        printed = self.succeed("analyse", folder, LABORATORY / "adv-profile.csv", "--case", CASE, "--measured",
                               LABORATORY / "adv-profile.csv").stdout
        comparison = printed[printed.index("Comparison"):]
        self.assertIn("friction velocity u*, log-law fit", comparison)

    def test_what_is_wrong_is_told(self):
        folder = self.run_small("run", 0.3)
        self.fail_with(3, "analyse", self.folder / "nothing", says=["nothing"])
        self.fail_with(2, "analyse", LABORATORY / "adv-point.csv", "--frequency", "-3",
                       says=["must be a number greater than 0"])
        self.fail_with(2, "analyse", folder, "--chapter", "waves", says=["statistics", "surface"])
        self.fail_with(2, "analyse", folder, "--window", "5,9", says=["--window", "0.3"])
        self.fail_with(2, "analyse", folder, "--frequency", "100", says=["--frequency", "CSV"])
        self.fail_with(3, "analyse", folder, "--measured", self.folder / "none.csv", says=["none.csv"])
        bad = self.folder / "bad.csv"
        bad.write_text("z,u\n0.01,0.2\n0.02,fast\n")
        self.fail_with(3, "analyse", bad, says=["bad.csv", "3"])
        short = self.succeed("analyse", folder).stdout
        self.assertIn("Warnings", short)

    def test_a_case_without_surface_or_flow_is_analysed_too(self):
        folder = self.folder / "tank"
        self.succeed("run", SOURCE / "cases/checks/taylor-green.toml", "-o", folder, "-q", *until(0.1))
        printed = self.succeed("analyse", folder).stdout
        # Its kind of flow has a course; what a chapter made for other kinds lacks, it says when asked for.
        self.assertIn("Course of the flow", printed)
        self.assertNotIn("Free surface", printed)
        # What it is to be compared with must be there all the same, and is said to be of no use.
        self.fail_with(3, "analyse", folder, "--measured", self.folder / "none.csv", says=["none.csv"])
        (self.folder / "profile.csv").write_text("z,u\n0.01,0.2\n0.02,0.3\n")
        self.assertIn("nothing of this run is compared",
                      " ".join(self.succeed("analyse", folder, "--measured", self.folder / "profile.csv").stdout.split()))
        self.assertIn("the case has no free surface", self.succeed("analyse", folder, "--chapter", "surface").stdout)


if __name__ == "__main__":
    main()
