"""`riffle preview`: the page and the drawing of a case before any run."""
import re
import xml.etree.ElementTree

from riffle_cli import CASE, SMALL, SOURCE, CommandLineTest, main

SVG = "{http://www.w3.org/2000/svg}"


class Preview(CommandLineTest):
    def preview(self, case, *options):
        page = self.folder / "case.html"
        result = self.succeed("preview", case, "-o", page, *options)
        self.assertEqual(result.stdout.splitlines()[-2:], [str(page), str(page.with_suffix(".svg"))])
        drawing = xml.etree.ElementTree.parse(page.with_suffix(".svg")).getroot()
        self.assertEqual(drawing.tag, SVG + "svg")
        words = [element.text for element in drawing.iter(SVG + "text")]
        return page.read_text(), drawing, words

    def test_a_plane_channel(self):
        page, drawing, words = self.preview(CASE, *SMALL)
        for word in ("Side view", "Particles", "periodic", "x, mm", "z, mm"):
            self.assertIn(word, words)
        self.assertNotIn("Plan", words)
        self.assertRegex(page, r"(?i)^<!doctype html")
        for word in ("Numbers", "particle spacing", "memory at the peak", "standard_velocity", "<svg"):
            self.assertIn(word, page)
        # It needs nothing beside itself.
        self.assertEqual(re.findall(r"(?:src|href)=", page), [])

    def test_space_with_a_shape_and_instruments(self):
        page, drawing, words = self.preview(SOURCE / "cases/solids/pier.toml", "--geometry-only")
        for word in ("Side view", "Plan", "Cross-section", "pier", "y, mm", "A", "B", "1", "5 × 4 mm"):
            self.assertIn(word, words)
        self.assertNotIn("memory at the peak", page)
        for word in ("cylinder", "-5 mm to 65 mm", "before_and_behind", "50 Hz"):
            self.assertIn(word, page)

    def test_a_bed_from_data_says_what_was_made_of_it(self):
        page, drawing, words = self.preview(SOURCE / "cases/solids/gravel-bed-3d.toml", "--geometry-only")
        self.assertIn("bed, z", words)
        for word in ("What was made of the data", "3 of 2400 heights were missing, in 1 hole",
                     "standard deviation"):
            self.assertIn(word, page)

    def test_all_kinds_of_cases_are_drawn(self):
        for case in ("open-ends/drop", "checks/gate", "checks/beach", "violent/box-3d", "checks/taylor-green",
                     "rough-bed-3d/condition-1-coarse", "checks/lid-driven-cavity", "plane-beds/smooth"):
            with self.subTest(case=case):
                page, drawing, words = self.preview(SOURCE / f"cases/{case}.toml", "--geometry-only")
                self.assertIn("Side view", words)
                text = (self.folder / "case.svg").read_text()
                self.assertNotRegex(text, r"\b(nan|inf)\b")

    def test_a_name_of_a_case_is_text(self):
        page, drawing, words = self.preview(CASE, *SMALL, "--geometry-only", "--set",
                                            "title='<script>alert(1)</script>'")
        self.assertNotIn("<script", page)

    def test_what_is_wrong_is_said(self):
        self.fail_with(3, "preview", self.folder / "none.toml", says=["there is no such case file"])
        self.fail_with(2, "preview", CASE, "-o", self.folder / "case.png", says=["NAME.html"])
        other = self.folder / "notes.html"
        other.write_text("my notes")
        self.fail_with(2, "preview", CASE, "-o", other, "--geometry-only", says=["notes.html"])
        self.assertEqual(other.read_text(), "my notes")


if __name__ == "__main__":
    main()
