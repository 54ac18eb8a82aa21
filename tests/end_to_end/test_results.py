"""The results of a run: complete, readable by other programs, the same for any thread count."""
import subprocess
import sys

from riffle_cli import CASE, SKIPPED, SMALL, SOURCE, CommandLineTest, every, main, text, until


# Their sum falls short of 0.3 s by 1.7e-14 s.
LAST_STEP, LAST_STEPS = 1e-4, 3000


class Results(CommandLineTest):
    def test_snapshots_stand_at_their_times_and_at_the_end(self):
        import h5py

        folder = self.run_small("run", 0.45, *every(snapshot=0.2))
        with h5py.File(folder / "results.h5", "r") as file:
            self.assertEqual(file.attrs["complete"], 1)
            self.assertEqual(sorted(file["snapshots"]), ["00000", "00001", "00002", "00003"])
            *times, last = [file["snapshots"][name].attrs["time"] for name in sorted(file["snapshots"])]
            self.assertEqual(last, file["summary"].attrs["simulated_time"], "the state that the run ends in")
            step = file["time_series/time_step"][...].max()
            for number, time in enumerate(times):
                self.assertTrue(0 <= time - 0.2 * number <= step, f"snapshots at {times} s")

    def test_solids_their_motion_and_the_forces_on_them_are_there(self):
        folder = self.folder / "gate"
        self.succeed("run", SOURCE / "cases/checks/gate.toml", "-o", folder, "-q", "--set", "numerics.spacing=5mm", *until(0.35), *every(snapshot=0.1))
        import h5py

        with h5py.File(folder / "results.h5", "r") as file:
            for name in ("walls/position", "walls/body", "solids/vertices", "solids/body"):
                self.assertIn(name, file["boundaries"])
            last = file["snapshots"][sorted(file["snapshots"])[-1]]
            # The gate rises by 3 m/s for 0.05 s.
            rise = last["solid_vertices"][:, 2] - file["boundaries/solids/vertices"][:, 2]
            self.assertTrue((abs(rise - 0.15) < 3e-3).all(), rise)
            force = file["probes/standard_force"]
            for name in ("solid_force_1", "solid_form_drag_1", "solid_lift_1"):
                self.assertEqual(text(force[name].attrs["units"]), "N/m")
            # Before it is pulled the gate holds the reservoir: rho g h^2 / 2.
            time, held = force["time"][:], force["solid_force_1"][:]
            mean = held[(time > 0.15) & (time < 0.3)].mean()
            self.assertAlmostEqual(mean / (0.5 * 9810 * 0.1**2), 1, delta=0.1)

    def test_a_run_shorter_than_its_snapshots_keeps_the_last_state(self):
        import h5py

        folder = self.run_small("short", 0.1, *every(snapshot=5))
        with h5py.File(folder / "results.h5", "r") as file:
            names = sorted(file["snapshots"])
            self.assertEqual(len(names), 2)
            self.assertAlmostEqual(file["snapshots"][names[-1]].attrs["time"], file["summary"].attrs["simulated_time"])
        whole = self.run_small("whole", 0.2, *every(snapshot=5))
        self.succeed("resume", folder, "-q", *until(0.2))
        with h5py.File(folder / "results.h5", "r") as one, h5py.File(whole / "results.h5", "r") as other:
            self.assertEqual(sorted(one["snapshots"]), sorted(other["snapshots"]))
            for name in one["snapshots"]:
                self.assertTrue((one[f"snapshots/{name}/position"][:] == other[f"snapshots/{name}/position"][:]).all())

    def test_the_last_samples_are_kept_where_the_steps_add_up_to_the_end_but_for_rounding(self):
        import h5py

        total = 0.0
        for _ in range(LAST_STEPS):
            total += LAST_STEP
        self.assertLess(total, LAST_STEPS * LAST_STEP, "rounding must fall short of the end for this test to say anything")
        folder = self.run_small("even", LAST_STEPS * LAST_STEP, "--set", f"numerics.time_step={LAST_STEP} s")
        with h5py.File(folder / "results.h5", "r") as file:
            for times in ("time_series/time", "profile_blocks/time", "surface/time", "probes/standard_velocity/time"):
                self.assertAlmostEqual(file[times][-1], LAST_STEPS * LAST_STEP, delta=1e-9, msg=times)

    def test_series_and_profiles_are_finite_and_in_order(self):
        import h5py
        import numpy

        folder = self.run_small("run", 0.45)
        with h5py.File(folder / "results.h5", "r") as file:
            time = file["time_series/time"][...]
            self.assertTrue((numpy.diff(time) > 0).all())
            self.assertAlmostEqual(time[-1], 0.45, delta=0.03)
            for group in ("time_series", "surface", "profile_blocks", "column"):
                for name, data in file[group].items():
                    self.assertTrue(numpy.isfinite(data[...]).all(), f"/{group}/{name}")
            self.assertTrue((numpy.diff(file["profiles/bin_upper"][...]) > 0).all())
            self.assertAlmostEqual(file["summary"].attrs["mean_level"], 0.056, delta=0.001)

    def test_any_number_of_threads_gives_the_same_bits(self):
        case = self.case_with_probes()
        one = self.run_small("one", 0.45, *every(snapshot=0.2), threads=1, case=case)
        for threads in (2, 3):
            self.assert_same_results(one, self.run_small(f"threads-{threads}", 0.45, *every(snapshot=0.2),
                                                         threads=threads, case=case))

    def test_any_number_of_threads_gives_the_same_bits_in_three_dimensions(self):
        case = self.space_case_with_probes()
        one = self.run_space("one", 0.2, *every(snapshot=0.1), threads=1, case=case)
        self.assert_same_results(one, self.run_space("three", 0.2, *every(snapshot=0.1), threads=3, case=case))

    def test_the_instruments_record_what_check_forecasts(self):
        import h5py
        import json

        case = self.case_with_probes()
        folder = self.run_small("run", 0.45, case=case)
        forecast = json.loads(self.succeed("check", case, "--json", *SMALL, *until(0.45)).stdout)
        with h5py.File(folder / "results.h5") as file:
            probes = file["probes"]
            self.assertEqual({p["name"] for p in forecast["probes"]}, set(probes))
            for probe in forecast["probes"]:
                group = probes[probe["name"]]
                self.assertEqual(text(group.attrs["kind"]), probe["kind"])
                self.assertEqual(group.attrs["standard"], probe["standard"])
                self.assertEqual(group.attrs["sampling_frequency"], probe["sampling_frequency"])
                recorded = sum(data.nbytes for name, data in group.items() if name not in ("x", "z"))
                # The last sample may wait for a step beyond the end, or the end lie a step behind it.
                row = recorded / max(1, group["time"].size)
                self.assertLessEqual(abs(recorded - probe["bytes"]), row, probe["name"])
                self.assertGreater(probe["time_share"], 0)

    def test_check_forecasts_what_a_run_in_three_dimensions_records(self):
        import h5py
        import json

        case = self.space_case_with_probes()
        options = [*every(snapshot=0.1), "--set", 'output.snapshot_y=["0 mm", "21.65065 mm"]']
        folder = self.run_space("run", 0.451, *options, case=case)
        forecast = json.loads(self.succeed("check", case, "--json", *until(0.451), *options).stdout)
        parts = {part["name"]: part["bytes"] for part in forecast["disk_parts"]}
        self.assertAlmostEqual(sum(parts.values()), forecast["disk_bytes"], delta=1)

        def recorded(file, groups, leave_out=("x", "y", "z", "point")):
            sizes = []
            for group in groups:
                if group in file:
                    file[group].visititems(lambda name, item: sizes.append(
                        item.nbytes if isinstance(item, h5py.Dataset) and name.split("/")[-1] not in leave_out else 0))
            return sum(sizes)

        with h5py.File(folder / "results.h5") as file:
            self.assertEqual(recorded(file, ["mean_field"]), parts["mean field"])
            # A record more or less at the ends of the run.
            for groups, name, tolerance in ((["surface_map"], "surface map", 0.3), (["surface"], "surface", 0.1),
                                            (["probes"], "probes", 0.1), (["snapshots"], "snapshots", 0.25),
                                            (["time_series", "profile_blocks"], "series and profiles", 0.2)):
                size = recorded(file, groups)
                self.assertLess(abs(size / parts[name] - 1), tolerance, f"{name}: {size} of {parts[name]} bytes")

    def test_the_mean_field_agrees_with_the_layers(self):
        import h5py
        import numpy

        folder = self.run_space("run", 0.31)
        with h5py.File(folder / "results.h5") as file:
            field = file["mean_field"]
            self.assertEqual(field["velocity"].shape[0], 2)
            numpy.testing.assert_allclose(field["time"][...], [0.15, 0.3])
            count, velocity = field["count"][...].astype(float), field["velocity"][...].astype(float)
            particles = file["summary"].attrs["particles"]
            numpy.testing.assert_allclose(count.sum(axis=(1, 2, 3)), particles, rtol=1e-5)  # single precision
            # Both windows together are the first three blocks, the layers are the rows of cells.
            names = text(file["profile_blocks"].attrs["quantities"]).split()
            sums = file["profile_blocks/sums"][:3].sum(axis=0)
            samples = field["samples"][...]
            momentum = (numpy.nan_to_num(velocity) * count).sum(axis=(2, 3))
            layers = (momentum * samples[:, None]).sum(axis=0)
            numpy.testing.assert_allclose(layers, sums[:, names.index("u")], rtol=1e-4)

    def test_the_instruments_agree_with_the_other_records(self):
        import h5py
        import numpy

        # Force balance and time series at the same instants: every 0.02 s.
        folder = self.run_small("run", 0.45, *every(series=0.02, surface=0.01), case=self.case_with_probes())
        with h5py.File(folder / "results.h5") as file:
            series, force = file["time_series"], file["probes/forces"]
            same = numpy.isin(force["time"][...], series["time"][...])
            self.assertGreater(same.sum(), 15)
            rows = numpy.isin(series["time"][...], force["time"][...])
            weight = force["weight_component"][...][same]
            for name, ratio in (("bed_drag", "drag_over_gravity"), ("wall_force", "wall_over_gravity")):
                difference = force[name][...][same] / weight - series[ratio][...][rows]
                self.assertLess(abs(difference).max(), 1e-9, name)  # sums of the same terms
            # The walls carry the water: 0.056 m of it over 0.06 m, and weak sound goes up and down in it.
            carried = 1000 * 9.81 * 0.056 * 0.06
            self.assertAlmostEqual(force["wall_normal_force"][...].mean() / carried, 1.0, delta=0.02)
            # Flow rate: its mean over even sections is the momentum of the water over density and length.
            sections = file["probes/sections"]
            u = sections["flow_rate"][...] / sections["depth"][...]
            mean = series["total_mean_velocity"][...].mean()
            self.assertLess(abs(u.mean() / mean - 1), 0.01)
            # The point at 20 mm lies on the column's profile that the run starts from.
            column = numpy.interp([0.02, 0.04], file["column/z"][...], file["column/velocity"][...])
            measured = file["probes/adv/velocity"][...][:, 1:3].mean(axis=0)
            self.assertLess(abs(measured / column - 1).max(), 0.02)
            self.assertTrue(numpy.isnan(file["probes/adv/velocity"][...][:, 3]).all(), "60 mm is in the air")

    def test_a_run_can_start_from_results(self):
        import h5py

        first = self.run_small("first", 0.2)
        second = self.run_small("second", 0.1, "--set", "start.kind=results", "--set",
                                f'start.file="{first / "results.h5"}"')
        with h5py.File(first / "results.h5") as a, h5py.File(second / "results.h5") as b:
            self.assertEqual(a["state/id"].shape, b["state/id"].shape)
            self.assertAlmostEqual(a["time_series/depth_mean_velocity"][-1],
                                   b["time_series/depth_mean_velocity"][0], delta=1e-3)

    def test_a_finer_and_longer_run_can_start_from_the_flow_of_another(self):
        import h5py

        first = self.run_small("first", 0.2)
        source = ["--set", "start.kind=results", "--set", f'start.file="{first / "results.h5"}"']
        second = self.run_small("second", 0.1, *source, "--set", "numerics.spacing=2mm", "--set", 'channel.length="120 mm"')
        with h5py.File(first / "results.h5") as a, h5py.File(second / "results.h5") as b:
            self.assertGreater(b["state/id"].shape[0], 3 * a["state/id"].shape[0])
            u = a["time_series/depth_mean_velocity"][-1]
            self.assertLess(abs(b["time_series/depth_mean_velocity"][0] / u - 1), 0.01)
        self.fail_with(2, "run", CASE, "-o", self.folder / "third", *SMALL, *until(0.1), *source, "--set", 'channel.length="90 mm"',
                       says=["channel.length is 0.06 m there and 0.09 m here", "several times"])

    def test_a_start_from_results_has_the_density_of_its_own_case_and_no_water_in_its_solids(self):
        import h5py

        first = self.run_small("first", 0.05)
        source = ["--set", "start.kind=results", "--set", f'start.file="{first / "results.h5"}"']
        second = self.run_small("second", 0.02, *source, "--set", "fluid.density=900")
        with h5py.File(first / "results.h5") as a, h5py.File(second / "results.h5") as b:
            for name, share in (("water_volume", 1.0), ("gravity_power", 0.9)):
                before, after = a["time_series"][name][-1], b["time_series"][name][0]
                self.assertAlmostEqual(after / before, share, delta=0.02, msg=name)
        # A key that does nothing is told of, and a solid that stands where the water is refuses the start.
        told = self.succeed("run", CASE, "-o", self.folder / "third", *SMALL, *until(0.02), *source, "--set", "start.jitter=0.1")
        self.assertIn("start.jitter has no effect", told.stderr)
        case = self.folder / "with-plate.toml"
        case.write_text(CASE.read_text() + '\n[[solid]]\nname = "plate"\nx = ["10 mm", "30 mm", "30 mm", "10 mm"]\n'
                        'z = ["0 mm", "0 mm", "20 mm", "20 mm"]\n')
        self.fail_with(2, "run", case, "-o", self.folder / "fourth", *SMALL, *until(0.02), *source,
                       says=['particles of water stand in the solid "plate"', "[start] file"])

    def test_free_bodies_go_on_from_where_the_results_leave_them(self):
        import h5py
        import numpy

        case = SOURCE / "cases/bodies/floating-box.toml"
        common = ["-q", "-j", 1, "--set", "numerics.spacing=5mm", "--set", 'solid.box.centre=["200 mm", "140 mm"]']
        first, second = self.folder / "first", self.folder / "second"
        self.succeed("run", case, "-o", first, *common, *until(0.3))
        source = ["--set", "start.kind=results", "--set", f'start.file="{first / "results.h5"}"']
        self.succeed("run", case, "-o", second, *common, *source, *until(0.1))
        whole = self.folder / "whole"
        self.succeed("run", case, "-o", whole, *common, *until(0.4))

        def motion(folder, name):
            with h5py.File(folder / "results.h5") as file:
                force = file["probes/standard_force"]
                return force["time"][:], force[f"body_{name}_1"][:]

        # As in a run that was not broken off, to a fiftieth of what it has gone by then.
        for name in ("z", "velocity_z"):
            (time, value), (further, others) = motion(whole, name), motion(second, name)
            scale = abs(value - value[0]).max()
            self.assertGreater(len(others), 5)
            self.assertLess(abs(others - numpy.interp(0.3 + further, time, value)).max(), 0.02 * scale, name)
        # So with what components keep of each particle.
        self.succeed("run", case, "-o", self.folder / "filtered", *common, *source, "--set", "numerics.density_relaxation=0.2", *until(0.05))
        # Another weight, or water on other places: neither can go on.
        for change in ("solid.box.density=700", "numerics.spacing=4mm"):
            self.fail_with(2, "run", case, "-o", self.folder / "third", *common, *source, "--set", change, *until(0.1),
                           says=['at the end of that run the solid "box" stood elsewhere than the case draws it', "mm along z", "draw the solid where it stood then"])

    def test_the_case_in_the_results_runs_again_to_the_same_results(self):
        import h5py
        from riffle_cli import riffle

        first = self.run_small("first", 0.2)
        case = self.folder / "again.toml"
        with h5py.File(first / "results.h5") as file:
            text = file["case/text"][()]
            case.write_bytes(text if isinstance(text, bytes) else text.encode())
        result = riffle("run", case, "-o", self.folder / "second", "-q")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_same_results(first, self.folder / "second")

    def test_the_xdmf_index_opens_in_the_readers_of_paraview(self):
        self.assert_opens_in_paraview(self.run_small("run", 0.25, *every(snapshot=0.1)))

    def test_the_xdmf_indexes_of_three_dimensions_open_too(self):
        folder = self.run_space("run", 0.35, *every(snapshot=0.1))
        self.assertTrue((folder / "mean_field.xdmf").exists())
        self.assert_opens_in_paraview(folder)
        # Of a part of the water the number of particles changes from snapshot to snapshot.
        part = self.run_space("part", 0.35, *every(snapshot=0.1), "--set", 'output.snapshot_y=["5 mm", "17 mm"]',
                              "--set", 'output.snapshot_fields="velocity eddy_viscosity"')
        self.assert_opens_in_paraview(part)

    def assert_opens_in_paraview(self, folder):
        check = subprocess.run([sys.executable, SOURCE / "tests/end_to_end/check_xdmf.py", folder],
                               capture_output=True, text=True, timeout=120)
        if check.returncode == SKIPPED:
            self.skipTest(check.stdout.strip())
        self.assertEqual(check.returncode, 0, check.stdout + check.stderr)


if __name__ == "__main__":
    main()
