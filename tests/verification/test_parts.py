"""What the verification in Python is made of: neighbour sums, exact solutions, fits, bars."""

import math
import pathlib
import re
import sys
import tempfile
import textwrap
import unittest

import numpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent), str(HERE.parent / "validation")]

import exact  # noqa: E402
import on_pages  # noqa: E402
import shown_tables  # noqa: E402
from check import Check, known_misses, summary_table  # noqa: E402
from neighbours import neighbour_pairs, velocity_gradients  # noqa: E402
import runs  # noqa: E402
import validate  # noqa: E402
import verify  # noqa: E402
from spectra import energy_spectrum, velocity_on_grid  # noqa: E402


class Neighbours(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(1)
        self.x, self.z = random.uniform(0, 1.0, 400), random.uniform(0, 0.7, 400)

    def test_pairs_are_those_of_a_search_over_all(self):
        for periods in ((None, None), (1.0, None), (1.0, 0.7)):
            for radius in (0.07, 0.34):  # the second: less than three cells a period
                i, j, dx, dz = neighbour_pairs(self.x, self.z, radius, periods)
                apart = [self.x[None, :] - self.x[:, None], self.z[None, :] - self.z[:, None]]
                for values, period in zip(apart, periods):
                    if period:
                        values -= period * numpy.round(values / period)
                near = numpy.hypot(*apart) < radius
                numpy.fill_diagonal(near, False)
                self.assertEqual(sorted(zip(i, j)), sorted(zip(*numpy.nonzero(near))))
                numpy.testing.assert_allclose(numpy.hypot(dx, dz), numpy.hypot(*apart)[i, j])

    def test_gradients_of_a_linear_field_are_exact_among_disordered_particles(self):
        u, w = 2 * self.x - 3 * self.z, 0.5 * self.x + 7 * self.z
        gradients = velocity_gradients(self.x, self.z, u, w, numpy.full(400, 0.7 / 400), 0.08, (None, None))
        for found, slope in zip(gradients, (2, -3, 0.5, 7)):
            numpy.testing.assert_allclose(found, slope, atol=1e-9)


class Spectra(unittest.TestCase):
    def test_waves_among_disordered_points_have_their_energy_at_their_wave_number(self):
        random, side, points = numpy.random.default_rng(3), 2.0, 24
        lattice = (numpy.stack(numpy.meshgrid(*3 * [numpy.arange(points)], indexing="ij"), axis=-1).reshape(-1, 3) + 0.5) * side / points
        places = lattice + random.uniform(-0.2, 0.2, lattice.shape) * side / points
        k3 = 2 * math.pi / side * 3
        # A wave across its direction, and half as large one along it.
        velocity = numpy.stack([0.5 * numpy.cos(k3 * places[:, 0]), numpy.sin(k3 * places[:, 0]), numpy.zeros(len(places))], axis=-1)
        k, spectrum, compressive = energy_spectrum(velocity_on_grid(places, velocity, side, points), side)
        shell = 2 * math.pi / side  # width of a shell
        self.assertAlmostEqual(k[2], k3, delta=0.2 * shell)
        self.assertGreater(spectrum[2], 50 * numpy.delete(spectrum, 2).max())
        # The modes of a shell share its energy, and a lattice does not fill all shells alike.
        modes = numpy.stack(numpy.meshgrid(*3 * [numpy.arange(-4, 5)], indexing="ij"), axis=-1).reshape(-1, 3)
        filling = (numpy.rint(numpy.linalg.norm(modes, axis=1)) == 3).sum() / (4 * math.pi * (k[2] / shell) ** 2)
        self.assertAlmostEqual(spectrum[2] * shell * filling, 0.5 * (0.5**2 + 1) / 2, delta=0.01)
        self.assertAlmostEqual(compressive[2] / spectrum[2], 0.2, delta=0.005)


class ExactSolutions(unittest.TestCase):
    def test_ramp_profile_has_the_printed_values_and_the_slope_of_its_balance(self):
        xi = numpy.array([0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0])
        numpy.testing.assert_allclose(exact.ramp_profile(xi), [3.876, 5.505, 7.068, 8.040, 9.759, 11.161, 12.144, 12.378], atol=5e-4)
        slope = (exact.ramp_profile(xi[:-1] + 1e-6) - exact.ramp_profile(xi[:-1] - 1e-6)) / 2e-6
        length = numpy.minimum(0.41 * xi[:-1], 0.09)
        numpy.testing.assert_allclose((length * slope) ** 2, 1 - xi[:-1], rtol=1e-5)

    def test_start_up_series_begin_at_the_start_and_end_in_the_steady_flow(self):
        z = numpy.linspace(0.1, 0.9, 9)
        numpy.testing.assert_allclose(exact.poiseuille_start(2.0, 0.5, 1.0, z, 0.0), 0, atol=1e-4)
        numpy.testing.assert_allclose(exact.poiseuille_start(2.0, 0.5, 1.0, z, 50.0), 2 * z * (1 - z))
        numpy.testing.assert_allclose(exact.couette_start(3.0, 0.5, 1.0, z, 2e-4), 0, atol=1e-6)
        numpy.testing.assert_allclose(exact.couette_start(3.0, 0.5, 1.0, z, 50.0), 3 * z)
        numpy.testing.assert_allclose(exact.channel_start(2.0, 0.5, 1.0, 0.7, z, 1e-4), 0.7, atol=2e-3)
        numpy.testing.assert_allclose(exact.channel_start(2.0, 0.5, 1.0, 0.7, z, 50.0), 2 * z * (2 - z))

    def test_tilted_tank_starts_with_its_tilt(self):
        x = numpy.linspace(0.02, 0.38, 19)
        n, amplitude = exact.tilted_tank(0.02, 0.4, 0.1, 9.81, 0.0, [0.0], 4000)
        level = numpy.cos(numpy.outer(x, n) * math.pi / 0.4) @ amplitude[0]
        numpy.testing.assert_allclose(level, 0.02 * (0.2 - x), atol=2e-6)

    def test_drop_keeps_its_energy_and_reaches_the_published_axis(self):
        times = numpy.linspace(0, 1, 6)
        a, b, rate = exact.elliptic_drop(1.0, 1.0, times)
        numpy.testing.assert_allclose(rate**2 * (a**2 + b**2), 2, rtol=1e-8)
        self.assertAlmostEqual(exact.elliptic_drop(1.0, 100.0, [0.0076])[0][0], 1.95, delta=0.006)  # Monaghan (1994), his table

    def test_ritter_holds_the_volume(self):
        x = numpy.linspace(-3, 3, 60001)
        depth = exact.ritter_depth(9.81, 0.2, x, 0.5)
        self.assertAlmostEqual((depth - numpy.where(x < 0, 0.2, 0)).sum() * (x[1] - x[0]), 0, delta=1e-5)

    def test_fit_finds_the_oscillation_again(self):
        t = numpy.arange(0, 2, 0.004)
        value = 0.2 + numpy.exp(-0.8 * t) * (0.3 * numpy.cos(17 * t) - 0.7 * numpy.sin(17 * t))
        frequency, decay, fit = exact.fit_oscillation(t, value, 17.5, 1.0, offset=True)
        self.assertAlmostEqual(frequency, 17, delta=1e-9)
        self.assertAlmostEqual(decay, 0.8, delta=1e-9)
        numpy.testing.assert_allclose(fit, value, atol=1e-9)

    def test_waves_of_a_paddle_become_havelocks(self):
        frequency, depth, amplitude = 1.3757, 0.1, 0.003
        omega, k = 2 * math.pi * frequency, 10.0
        for _ in range(100):
            k = 0.5 * (k + omega**2 / 9.81 / math.tanh(k * depth))
        havelock = 2 * (math.cosh(2 * k * depth) - 1) / (math.sinh(2 * k * depth) + 2 * k * depth) * 2 * amplitude
        time, x = numpy.arange(0, 12, 0.01), numpy.linspace(0.4, 1.0, 7)
        late = time > 12 - 4 / frequency
        for across in (0.0, math.pi / 0.5):
            surface = exact.paddle_waves(time, x, amplitude, omega, across, depth, 8.0, 9.81)[late]
            height = 4 * numpy.abs(numpy.mean(surface * numpy.exp(1j * omega * time[late])[:, None], axis=0))
            expected = havelock * k / math.sqrt(k**2 - across**2)
            self.assertLess(numpy.abs(height / expected - 1).max(), 0.02)  # what the start leaves dies slowly

    def test_order(self):
        self.assertAlmostEqual(exact.observed_order([4, 2, 1], [16e-3, 4e-3, 1e-3]), 2)


class LongTier(unittest.TestCase):
    def test_each_check_and_each_part_is_a_test_of_the_long_tier(self):
        here = pathlib.Path(__file__).resolve().parent
        for file, name, known in ((here / "CMakeLists.txt", "long_checks", list(verify.CHECKS)),
                                  (here.parent / "validation/CMakeLists.txt", "long_parts", validate.TIERS["full"] + validate.TIERS["space"])):
            listed = re.search(rf"set\({name}\s([^)]*)\)", file.read_text()).group(1).split()
            self.assertEqual(sorted(listed), sorted(known))

    def test_a_run_is_taken_again_from_the_same_binary_only_and_goes_on_where_it_was_broken_off(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            # Stands for the program: it notes its calls and writes results, which are complete after a resume.
            said, binary, case = folder / "said", folder / "riffle", folder / "case.toml"
            case.write_text("title = 'x'\n")

            def program(remark):
                binary.write_text(f"#!/usr/bin/python3\n# {remark}\n" + textwrap.dedent(f"""
                    import h5py, pathlib, sys
                    verb, folder = sys.argv[1], pathlib.Path(sys.argv[sys.argv.index("-o") + 1] if "-o" in sys.argv else sys.argv[2])
                    open({str(said)!r}, "a").write(verb + "\\n")
                    with h5py.File(folder / "results.h5", "w") as file:
                        file.attrs["complete"] = int(verb == "resume" or "--set" in sys.argv)
                        for group in ("summary", "time_series", "snapshots"):
                            file.create_group(group)
                    (folder / "checkpoint.h5").touch()
                    """))
                binary.chmod(0o755)

            class Plain(runs.RiffleRun):
                def _measure_depth(self):
                    pass

            def calls(reuse, **settings):
                said.write_text("")
                Plain(binary, case, folder / "run", settings, reuse)
                return said.read_text().split()

            program("one build")
            self.assertEqual(calls("same build"), ["run"])  # broken off, as far as its results say
            self.assertEqual(calls("same build"), ["resume"])
            self.assertEqual(calls("same build"), [])
            program("another build")
            self.assertEqual(calls("any"), [])
            self.assertEqual(calls("same build", key=1), ["run"])
            self.assertEqual(calls("same build", key=1), [])
            case.write_text("title = 'y'\n")
            self.assertEqual(calls("same build", key=1), ["run"])
            self.assertEqual(calls("", key=1), ["run"])
            self.assertEqual(calls("any", key=2), ["run"])


class Bars(unittest.TestCase):
    def test_misses_and_known_failures_are_told_apart(self):
        check = Check("name", "Title", "text")
        check.norm("held", 0.009, 0.01)
        check.norm("stated", 0.5)
        check.norm("missed", -0.02, 0.01)
        check.norm("not a number", math.nan, 0.01)
        check.norm("known", 0.02, 0.01)
        table = summary_table([check.judge(_known(check, known={"value": 0.02, "worst": 0.021}))])
        self.assertEqual(table.checks, 4)
        self.assertEqual(len(table.missed), 2)
        self.assertIn("missed is -0.02", table.missed[0])
        self.assertEqual(len(check.known), 1)
        self.assertEqual([row[3] for row in table.rows], ["0.9 %", "50 %", "-2 % !", "nan % !", "2 % (fails)"])

    def test_known_misses_may_neither_grow_nor_go(self):
        for value, said in ((0.02, None), (0.022, "worse than"), (0.005, "holds its bar"), (0.0095, None)):
            check = Check("name", "Title", "text")
            check.norm("rms", value, 0.01)
            check.judge(_known(check, rms={"value": 0.02, "worst": 0.021}))
            self.assertEqual(len(check.missed), 0 if said is None else 1, value)
            if said:
                self.assertIn(said, check.missed[0])
        for value, verdict in ((0.005, "held"), (0.03, "missed")):  # an extreme of a flow that never repeats
            check = Check("name", "Title", "text")
            check.norm("rms", value, 0.01)
            check.judge(_known(check, rms={"value": 0.02, "worst": 0.021, "may_hold": True}))
            self.assertEqual(check.verdicts["rms"][0], verdict)
        check = Check("name", "Title", "text")
        check.norm("another", 0.0, 0.01)
        check.judge(_known(check, rms={"value": 0.02, "worst": 0.021}), complete=True)
        self.assertIn("no such value", check.missed[0])

    def test_two_values_of_one_name_are_told(self):
        check = Check("name", "Title", "text")
        check.norm("rms", 0.0, 0.01)
        check.norm("rms", 0.0, 0.01)
        self.assertRaises(ValueError, check.judge, {})

    def test_the_page_of_known_misses_is_that_of_the_list(self):
        root = pathlib.Path(__file__).resolve().parents[2]
        self.assertEqual((root / "docs/known-misses.md").read_text(), known_misses.page(known_misses.read(), known_misses.statements()))


PAGE = """# A page

## Norms

| case | error norm | bar | measured | best option set | cost |
|---|---|---|---|---|---|
| Tank | largest speed | 0.1 | 0.05 | as the case | 3 s of a core |
|  | level | stated | -1.5 % |  |  |
| Other | level | 1 % | 0.1 % |  |  |

### Tank: spacings (observed order 1.91)

| spacing | error % | s of a core |
|---|---|---|
| 2 mm | 0.25 | 4 |

<!-- test: checks="tank wedge" -->
| case | quantity | bar | measured |
|---|---|---|---|
| the tank | level at 3 s | 2 % | -1.5 % (1.7 % elsewhere) |
| | speed | 0.1 | 0.05 |
| the wedge | speed | 0.1 | 7 |
"""


class Readme(unittest.TestCase):
    def test_it_counts_the_checks_and_those_that_miss_a_bar(self):
        text = (runs.ROOT / "README.md").read_text(encoding="utf-8")
        found = re.search(r"\| (\d+) flows with exact, published or measured solutions, [^|]*\| (\d+) hold every bar, (\d+) miss some", text)
        missing = {miss.part for miss in known_misses.read().values() if miss.suite == "verification"}
        self.assertEqual([int(number) for number in found.groups()], [len(verify.CHECKS), len(verify.CHECKS) - len(missing), len(missing)])


class Pages(unittest.TestCase):
    """What a page shows of a check: the same, and each way to be wrong."""

    def check(self, speed=0.05, level=-0.015, error="0.25", title="Tank"):
        check = Check("tank", title, "text")
        check.norm("largest speed", speed, 0.1, "", 3)
        check.norm("level", level, None)
        check.best, check.cost = "as the case", "9 s of a core"
        table = validate.parts.Table("Tank: spacings (observed order 2.04)", ["spacing", "error %", "s of a core"])
        table.rows.append(["2 mm", error, "7"])
        check.tables.append(table)
        return check.judge({})

    def faults(self, page=PAGE, **values):
        self.comparison = shown_tables.Comparison(shown_tables.tables_of(page, "docs/page.md"))
        on_pages.compare(self.check(**values), self.comparison)
        return self.comparison.faults

    def test_the_same_numbers_pass_whatever_the_computer_took(self):
        self.assertEqual(self.faults(), [])
        self.assertEqual(self.comparison.rows, 5)
        self.assertEqual(self.faults(speed=0.07, level=-0.0158), [])  # a quarter of the bar; a tenth

    def test_another_number_is_told_with_its_place(self):
        fault, by_hand = self.faults(level=-0.03)
        self.assertIn("docs/page.md:8: Tank / level: measured is -1.5 %, printed -3 %", fault)
        self.assertIn("docs/page.md:20: the tank / level at 3 s: tank does not print -1.5", by_hand)
        self.assertEqual(len(self.faults(level=0.015)), 2)
        self.assertIn("error % is 0.25, printed 0.29", self.faults(error="0.29")[0])

    def test_rows_that_lack_or_are_gone_are_told(self):
        self.assertIn("no page shows Tank / level: |  | level | stated | -1.5 % |", self.faults(PAGE.replace("|  | level", "|  | height"))[0])
        more = self.faults(PAGE.replace("| Other |", "|  | depth | stated | 1 % |  |  |\n| Other |"))
        self.assertEqual(more, ["docs/page.md:9: Tank / depth is shown, and not printed any more"])
        self.assertIn("no page shows 2 mm: | 2 mm | 0.25 |", self.faults(PAGE.replace("| 2 mm |", "| 3 mm |"))[0])

    def test_a_mark_of_a_missed_bar_may_not_stand(self):
        self.assertEqual(len(self.faults(PAGE.replace("0.05 | as", "0.05 ! | as"))), 1)

    def test_a_check_that_no_page_shows_is_told(self):
        self.assertEqual(self.faults("# Nothing"), ["tank: no page shows it"])

    def test_rows_of_today_can_be_written(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            (folder / "docs").mkdir()
            (folder / "docs/page.md").write_text(PAGE)
            self.faults(speed=0.09, error="0.5")
            self.comparison.write(folder)
            page = (folder / "docs/page.md").read_text()
            self.assertIn("| Tank | largest speed | 0.1 | 0.09 | as the case | 9 s of a core |", page)
            self.assertIn("| 2 mm | 0.5 | 7 |", page)
            self.assertEqual([fault for fault in self.faults(page, speed=0.09, error="0.5") if "does not print" not in fault], [])

    def test_the_markers_of_the_pages_name_checks(self):
        for table in shown_tables.read():
            if table.checks:
                place = f"{table.page}, {table.title}"
                self.assertLessEqual(set(table.checks) - {"-"}, set(verify.CHECKS), place)
                if len(table.checks) > 1:
                    self.assertEqual(len(table.checks), sum(bool(cells[0]) for _, cells in table.rows), place)


def _known(check, **misses):
    entries = [known_misses.Miss({"suite": "verification", "part": check.name, "row": check.title, "quantity": label, "bar": 0.01, "reason": "r", **entry}, "here")
               for label, entry in misses.items()]
    return {miss.key: miss for miss in entries}


if __name__ == "__main__":
    unittest.main()
