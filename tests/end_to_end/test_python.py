"""The Python package that opens results files (python/riffle_results), on a real results file."""
import json
import os
import re
import resource
import subprocess
import sys
import unittest

from riffle_cli import CASE, SMALL, SOURCE, CommandLineTest, every, main, text, until

sys.path.insert(0, str(SOURCE / "python"))
try:
    import h5py
    import numpy
    import xarray
except ImportError as missing:
    print(f"skipped: {missing} (packages python3-h5py, python3-xarray)")
    sys.exit(77)
import riffle_results
from riffle_results import Results, ResultsError, open_results, read_analysis
from riffle_results import analysis as analysis_module
from riffle_results import results as results_module

# Coordinates that the package makes of attributes, or of their order.
MADE = {"axis", "quantity"}


class Package(CommandLineTest):
    @classmethod
    def setUpClass(cls):
        cls.shared = CommandLineTest("setUp")
        cls.shared.setUp()
        cls.run_folder = cls.shared.folder / "results/demo"
        cls.shared.succeed("run", CASE, "-o", cls.run_folder, "-j", 1, "-q", *SMALL, *until(0.9), *every(snapshot=0.3))

    @classmethod
    def tearDownClass(cls):
        cls.shared.doCleanups()

    def assert_refused(self, path, *words):
        with self.assertRaises(ResultsError) as caught:
            open_results(path)
        for word in (str(path), *words):
            self.assertIn(word, str(caught.exception))

    def test_every_array_is_there_with_its_values_units_and_name(self):
        self.assert_holds_every_array(self.run_folder, ("time_series", "profiles", "profile_blocks", "surface", "column"))

    def test_every_array_of_three_dimensions_is_there_too(self):
        folder = self.run_space("space", 0.45, *every(snapshot=0.2), case=self.space_case_with_probes())
        self.assert_holds_every_array(folder, ("time_series", "profiles", "profile_blocks", "surface", "column",
                                               "mean_field", "surface_map"))
        with open_results(folder) as run:
            field = run.mean_field
            self.assertEqual(field.velocity.dims, ("time", "z", "y", "x"))
            means = field.velocity.sel(time=0.3, z=0.045, method="nearest").mean().item()
            self.assertAlmostEqual(means, float(run.summary["surface_velocity"]), delta=0.05)
            self.assertEqual(run.surface_map.elevation.dims, ("time", "y", "x"))
            self.assertEqual(run.probe("piv").velocity.dims, ("time", "z", "x"))
            self.assertAlmostEqual(run.probe("piv").y.item(), 0.04)
            self.assertEqual(run.probe("adv").velocity.dims, ("time", "point"))
            self.assertIn("mean_field", repr(run))

    def assert_holds_every_array(self, folder, names):
        with open_results(folder) as run, h5py.File(folder / "results.h5") as file:
            groups = {name: getattr(run, name) for name in names}
            groups |= {f"snapshots/{name}": run.snapshot(name) for name in run.snapshot_names}
            groups |= {f"probes/{name}": run.probe(name) for name in run.probe_names}
            groups |= {f"boundaries/{name}": run.boundary(name) for name in run.boundary_names}
            groups["lost_particles"] = run.lost_particles
            self.assertIn("walls", run.boundary_names)
            self.assertGreaterEqual(len(run.snapshot_names), 3)
            for name, dataset in groups.items():
                self.assertLessEqual(set(file[name]), set(dataset.variables), name)
                for key, array in file[name].items():
                    with self.subTest(array=f"{name}/{key}"):
                        variable = dataset[key]
                        numpy.testing.assert_array_equal(variable.values, array[()])
                        self.assertEqual(variable.dtype, array.dtype)
                        self.assertEqual(variable.attrs["units"], text(array.attrs["units"]))
                        self.assertTrue(variable.attrs["long_name"])
                for key, value in file[name].attrs.items():
                    if key not in ("time", "quantities"):
                        self.assertEqual(dataset.attrs[key], text(value))
            # No group of arrays of the file is left out but those for going on with the run.
            known = {name.split("/")[0] for name in groups} | {"snapshots", "probes"}
            self.assertLessEqual(set(file) - known, {"case", "state", "summary"})

    def test_dimensions_and_coordinates(self):
        with open_results(self.run_folder / "results.h5") as run:
            self.assertEqual(run.surface.elevation.dims, ("time", "x"))
            self.assertEqual(run.profile_blocks.sums.dims, ("time", "layer", "quantity"))
            self.assertEqual(run.snapshot(0).velocity.dims, ("particle", "axis"))
            self.assertEqual(float(run.snapshot(0).time), run.snapshot_times[0])
            self.assertEqual(set(run.profiles.coords), {"z", "bin_lower", "bin_upper"})
            chosen = run.time_series.sel(time=0.5, method="nearest")
            self.assertAlmostEqual(float(chosen.time), 0.5, delta=0.011)
            # The blocks and the profiles are two forms of the same averages.
            profiles, blocks = run.profiles, run.profile_blocks
            sums = blocks.sums.sel(time=slice(profiles.attrs["window_start"] + 0.05, None)).sum("time")
            mean = sums.sel(quantity="u") / sums.sel(quantity="count")
            numpy.testing.assert_allclose(mean, profiles.velocity, rtol=1e-10)

    def test_the_run_itself(self):
        with open_results(self.run_folder) as run:
            self.assertTrue(run.complete)
            self.assertIn("Flow condition 2", run.title)
            self.assertEqual(run.case["channel"]["slope"], 0.004)
            self.assertIn("[channel]", run.case_text)
            self.assertIsInstance(run.summary["depth_mean_velocity"], float)
            self.assertIsInstance(run.summary["steps"], int)
            self.assertIsInstance(run.summary["convergence"], str)
            self.assertIn("snapshots: ", repr(run))
        self.assertIn("closed", repr(run))

    def test_what_was_used_outlives_the_file_and_the_rest_says_so(self):
        with open_results(self.run_folder) as run:
            series, surface = run.time_series.load(), run.surface
        self.assertGreater(float(series.depth_mean_velocity.mean()), 0.3)
        with self.assertRaisesRegex(ValueError, "closed"):
            surface.elevation.load()
        with self.assertRaises(Exception):
            with open_results(self.run_folder) as run:
                raise RuntimeError
        self.assertIn("closed", repr(run))

    def test_a_change_in_memory_does_not_reach_the_file(self):
        before = (self.run_folder / "results.h5").read_bytes()
        with open_results(self.run_folder) as run:
            series = run.time_series
            series.depth_mean_velocity[:] = 0.0
            self.assertEqual(float(series.depth_mean_velocity.max()), 0.0)
        self.assertEqual((self.run_folder / "results.h5").read_bytes(), before)

    def test_selections_are_those_of_numpy(self):
        with open_results(self.run_folder) as run, h5py.File(self.run_folder / "results.h5") as file:
            whole = file["surface/elevation"][()]
            for selection in (numpy.s_[3], numpy.s_[-1, ::2], numpy.s_[::-1], numpy.s_[5:1:-2, [3, 0, 3]], numpy.s_[..., 1],
                              numpy.s_[[4, 1], :], numpy.s_[whole[:, 0] > 0, 2]):
                numpy.testing.assert_array_equal(run.surface.elevation[selection].values, whole[selection], str(selection))
            pairs = {"time": xarray.DataArray([1, 0]), "x": xarray.DataArray([2, 2])}
            numpy.testing.assert_array_equal(run.surface.elevation.isel(pairs).values, whole[[1, 0], [2, 2]])

    def test_a_file_far_larger_than_memory_opens(self):
        path = self.folder / "large.h5"
        rows, columns = 10_000_000, 10_000  # 400 GB if it were written; HDF5 keeps no chunks that are not
        self.write(path, version=results_module.VERSION)
        with h5py.File(path, "a") as file:
            file.create_dataset("surface/elevation", (rows, columns), "f4", chunks=(100, columns), fillvalue=0.5)
            file["surface/x"] = numpy.arange(columns, dtype=float)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        with open_results(path) as run:
            self.assertEqual(run.surface.elevation.shape, (rows, columns))
            self.assertEqual(float(run.surface.elevation[-1].mean()), 0.5)
        self.assertLess(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before, 500_000)  # kB

    def write(self, path, version, kind="riffle-results"):
        with h5py.File(path, "w") as file:
            file.attrs["format"] = kind
            file.attrs["format_version"] = version
            file.attrs["riffle_version"] = "9.9.9"

    def test_files_that_are_not_results(self):
        self.assert_refused(self.folder / "missing.h5", "no such file")
        self.assert_refused(self.folder, "no results.h5")
        text = self.folder / "text.h5"
        text.write_text("no HDF5")
        self.assert_refused(text, "not an HDF5 file")
        truncated = self.folder / "truncated.h5"
        truncated.write_bytes((self.run_folder / "results.h5").read_bytes()[:5000])
        self.assert_refused(truncated, "truncated or damaged")
        foreign = self.folder / "foreign.h5"
        h5py.File(foreign, "w").close()
        self.assert_refused(foreign, "not a results file of Riffle")
        self.assert_refused(self.run_folder / "checkpoint.h5")

    def test_other_versions_of_the_format(self):
        path = self.folder / "other.h5"
        self.write(path, results_module.VERSION + 1)
        self.assert_refused(path, f"version {results_module.VERSION + 1}", "9.9.9", "package that came with that Riffle")
        self.write(path, results_module.VERSION - 1)
        self.assert_refused(path, f"version {results_module.VERSION - 1}", "run the case again")

    def test_versions_are_those_of_the_sources(self):
        for module, header, name in ((results_module, "src/output/results_file.hpp", "results_format_version"),
                                     (analysis_module, "src/analysis/analysis_json.hpp", "analysis_json_version")):
            if (SOURCE / header).exists():
                found = re.search(rf"{name} = (\d+)", (SOURCE / header).read_text())
                self.assertEqual(module.VERSION, int(found[1]), header)

    def test_what_is_not_in_the_file(self):
        path = self.folder / "results.h5"
        self.write(path, results_module.VERSION)
        with open_results(self.folder) as run:
            for access in (lambda: run.profiles, lambda: run.summary, lambda: run.snapshot(), lambda: run.probe("adv")):
                with self.assertRaises(ResultsError) as caught:
                    access()
                self.assertIn(str(path), str(caught.exception))
            self.assertEqual((run.snapshot_names, run.probe_names, run.complete), ([], [], False))

    def test_probes_of_every_form(self):
        path = self.folder / "probes.h5"
        self.write(path, results_module.VERSION)
        time = numpy.arange(5) / 100

        def probe(file, name, kind, axes, **arrays):
            group = file.create_group(f"probes/{name}")
            group.attrs.update(kind=kind, sampling_frequency=100.0, standard=0)
            for key, values in {"time": time, **axes, **arrays}.items():
                group[key] = values
                group[key].attrs.update(units="m", long_name=key)

        with h5py.File(path, "a") as file:
            probe(file, "adv", "velocity", {"x": [0.0, 0.1, 0.1], "z": [0.01, 0.01, 0.02]}, velocity=numpy.ones((5, 3)),
                  vertical_velocity=numpy.zeros((5, 3)))
            probe(file, "gauges", "wave", {"x": [0.0, 0.1]}, elevation=numpy.ones((5, 2)))
            probe(file, "piv", "grid", {"x": [0.0, 0.1], "z": [0.01, 0.02, 0.03]}, samples=numpy.ones(5),
                  velocity=numpy.arange(30.0).reshape(5, 3, 2))
            probe(file, "bed", "force", {}, drag=numpy.ones(5))
        with open_results(path) as run:
            self.assertEqual(run.probe_names, ["adv", "bed", "gauges", "piv"])
            adv = run.probe("adv")
            self.assertEqual(adv.velocity.dims, ("time", "point"))
            self.assertEqual(set(adv.coords), {"time", "x", "z"})
            self.assertEqual((adv.attrs["kind"], adv.attrs["sampling_frequency"]), ("velocity", 100.0))
            self.assertEqual(run.probe("gauges").elevation.sel(x=0.1, method="nearest").dims, ("time",))
            self.assertEqual(run.probe("bed").drag.dims, ("time",))
            piv = run.probe("piv")
            self.assertEqual((piv.velocity.dims, piv.samples.dims), (("time", "z", "x"), ("time",)))
            self.assertEqual(float(piv.velocity.isel(time=1).sel(z=0.03, x=0.1, method="nearest")), 11)

    def test_analyses(self):
        path = self.folder / "analysis.json"
        axis = {"label": "height", "unit": "m", "logarithmic": False}
        curve = {"name": "mean", "origin": "simulated", "mark": "line", "run": "demo", "variant": 0, "x": [1, None, 3],
                 "y": [4, 5, 6], "x_half_width": [], "y_half_width": [0.1, 0.2, None]}
        colours = {"label": "elevation", "unit": "m", "run": "demo", "x": [0, 1], "y": [0, 1, 2], "values": [1, 2, 3, 4, 5, None]}
        figure = {"key": "profile", "title": "Profile", "x": axis, "y": axis, "curves": [curve, curve], "maps": [colours]}
        finding = {"key": "friction_velocity", "chapter": "fits", "label": "u_*", "unit": "m/s", "value": 0.044,
                   "half_width": None, "reference": 0.04, "reference_name": "measured", "remark": ""}
        content = {"format": "riffle-analysis", "format_version": 1, "riffle_version": "9.9.9",
                   "analyses": [{"name": "demo", "source": "results.h5", "warnings": ["short"], "findings": [finding],
                                 "figures": [figure, {**figure, "key": "empty", "curves": [], "maps": []}]}]}
        path.write_text(json.dumps(content))
        analysis, = read_analysis(path)
        self.assertEqual((analysis.name, analysis.warnings, analysis.figure_keys), ("demo", ["short"], ["profile", "empty"]))
        self.assertEqual(analysis.findings.loc["friction_velocity", "value"], 0.044)
        self.assertTrue(numpy.isnan(analysis.findings.loc["friction_velocity", "half_width"]))
        curves = analysis.curves("profile")
        numpy.testing.assert_array_equal(curves.x[:3], [1, numpy.nan, 3])
        numpy.testing.assert_array_equal(curves.y_half_width[3:], [0.1, 0.2, numpy.nan])
        self.assertTrue(curves.x_half_width.isna().all() and len(curves) == 6)
        self.assertEqual(len(analysis.curves("empty")), 0)
        elevation, = analysis.maps("profile")
        self.assertEqual((elevation.dims, float(elevation.sel(y=1, x=1)), elevation.x.attrs["units"]), (("y", "x"), 4, "m"))
        with self.assertRaisesRegex(ResultsError, "no figure 'x'; it has profile, empty"):
            analysis.figure("x")
        for broken, words in ((path.read_text().replace("riffle-analysis", "other"), "not an analysis"),
                              (path.read_text().replace('version": 1', 'version": 2'), "version 2"), ("{", "as JSON")):
            path.write_text(broken)
            with self.assertRaisesRegex(ResultsError, words):
                read_analysis(path)
        with self.assertRaisesRegex(ResultsError, "no such file"):
            read_analysis(self.folder / "missing.json")

    def python(self, *arguments, **options):
        result = subprocess.run([sys.executable, *map(str, arguments)], capture_output=True, text=True, timeout=240,
                                cwd=self.shared.folder, env={**os.environ, "PYTHONPATH": str(SOURCE / "python")}, **options)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def test_the_programs_of_the_documentation_run(self):
        programs = re.findall(r"```python\n(.*?)```", (SOURCE / "docs/python.md").read_text(), re.DOTALL)
        self.assertEqual(len(programs), 3)
        self.succeed("analyse", self.run_folder, "--json", self.shared.folder / "analysis.json")
        self.assertIn("m/s in the top layer", self.python("-W", "error", "-c", "\n".join(programs)))

    def test_the_example_draws(self):
        picture = self.folder / "figure.png"
        printed = self.python(SOURCE / "python/examples/profile_and_spectrum.py", self.run_folder, picture)
        self.assertIn("standard deviation", printed)
        if "matplotlib is not installed" not in printed:
            self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")

    def test_the_example_says_what_it_lacks(self):
        """A flow between open ends has no twin, and is drawn without; a tank has no profiles."""
        tank = self.folder / "tank.toml"
        tank.write_text('[channel]\nslope = 0\ndepth = "50 mm"\nlength = "0.2 m"\nends = "walls"\n[bed]\nkind = "slip"\n'
                        '[turbulence]\nclosure = "none"\n[numerics]\npreset = "violent"\nspacing = "5 mm"\n[start]\n'
                        'kind = "rest"\nwater_x = [0, 0.1, 0.1, 0]\nwater_z = [0, 0, 0.05, 0.05]\n[run]\nuntil = "0.1 s"\n')
        self.succeed("run", tank, "-o", self.folder / "tank", "-q", "-j", 1)
        example = SOURCE / "python/examples/profile_and_spectrum.py"
        with self.assertRaises(AssertionError) as failed:
            self.python(example, self.folder / "tank", self.folder / "tank.png")
        self.assertIn("has no profiles", str(failed.exception))
        self.assertNotIn("Traceback", str(failed.exception))
        self.succeed("run", SOURCE / "cases/open-ends/uniform.toml", "-o", self.folder / "open", "-q", "-j", 1, *until(0.6),
                     "--set", "numerics.spacing=5mm", "--set", "channel.length=0.3", "--set", "run.average_from=0.1")
        self.assertIn("standard deviation", self.python(example, self.folder / "open", self.folder / "open.png"))

    def test_names_of_the_package_are_documented(self):
        page = (SOURCE / "docs/python.md").read_text()
        for name in riffle_results.__all__:
            self.assertTrue(name in page or name in ("Analysis", "Results"), name)
        for name in (name for name in vars(Results) if not name.startswith("_")):
            self.assertTrue(f"run.{name}" in page or name in ("close", "snapshot_names"), name)


if __name__ == "__main__":
    main()
