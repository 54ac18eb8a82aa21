"""The fields of the results: what the table says is written, nothing else is, and each is read by somebody."""
import http.client
import json
import re
import shutil
import tempfile
from pathlib import Path

from riffle_cli import CASE, SMALL, SOURCE, SPACE_CASE, SPACE_PROBES, PROBES, CommandLineTest, every, main, riffle, start, text, until

import h5py
import numpy

FREQUENCY = '\n[[probe]]\nname = "frames"\nkind = "grid"\nsampling_frequency = "20 Hz"\naveraging_time = 0\n'
VEGETATION = '''
[[vegetation]]
name = "stems"
stems_per_area = "400 1/m2"
stem_diameter = "6 mm"
height = "30 mm"
'''
POROUS = '''
[[porous]]
name = "gravel"
porosity = 0.4
grain_size = "5 mm"
z_to = "25 mm"
'''
CONDUIT = {"three_dimensions", "free_surface", "column_twin", "section_twin", "closure", "spheres", "asked", "end", "profiles", "slope", "periodic_ends"}
# What hangs on the numbers of the run; it may be written, and may not.
MAYBE = {"samples", "fitted", "level_surface", "relaxation"}
# Read, but not of runs as short and as calm as these; the tests of the analysis and of sweeps read them.
ELSEWHERE = {
    ("/", "failure"): "a sweep, of runs that failed",
    ("/column", "total_mean_velocity"): "a sweep, as the twin of an outcome",
    ("/column", "vegetation_share"): "the forces of channels without side walls",
    ("/column", "porous_share"): "so",
    ("/section", "bulk_velocity"): "a sweep in three dimensions, as the twin of an outcome",
    ("/summary", "secondary_velocity"): "a sweep in three dimensions",
    ("/summary", "lost_share"): "the diagnostics, where water was lost",
    ("/profiles", "velocity_half_width"): "the velocity profile, from ten independent samples on",
    ("/profiles", "spanwise_velocity_rms"): "the turbulence of channels without side walls",
    ("/mean_field", "pressure"): "the maps of channels with bodies",
    ("/time_series", "front_upstream"): "the front of water that moves against x",
    ("/snapshots", "solid_vertices"): "the picture of a flow in three dimensions whose solids move",
    ("surface_line", "elevation"): "the surface, where a line has more points than the record", ("surface_line", "time"): "so",
    **{("velocity", name): "records long enough for spectra"
       for name in ("time", "x", "y", "z", "velocity", "vertical_velocity", "spanwise_velocity")},
    **{("frames", name): "records long enough for correlations" for name in ("time", "x", "y", "z", "velocity", "vertical_velocity")},
}


class Fields(CommandLineTest):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.shared = Path(tempfile.mkdtemp(prefix="riffle-fields-"))
        cls.addClassCleanup(shutil.rmtree, cls.shared, ignore_errors=True)
        cls.groups = json.loads(riffle("schema", "--results").stdout)["groups"]
        plane, space, bare, bed = (cls.shared / f"{name}.toml" for name in ("plane", "space", "bare", "bed"))
        bed.write_text(SPACE_CASE + POROUS)
        bare.write_text(SPACE_CASE)
        plane.write_text(CASE.read_text() + PROBES + FREQUENCY)
        space.write_text(SPACE_CASE + SPACE_PROBES + FREQUENCY + VEGETATION)
        snapshots = every(snapshot=0.2)
        # By run: its command, and the conditions of the table that it meets.
        runs = {
            "plane": ([plane, *SMALL, *until(0.7), *snapshots],
                      {"free_surface", "column_twin", "no_section_twin", "closure", "asked", "end", "profiles", "slope", "periodic_ends"}),
            "space": ([space, *until(0.5), *snapshots, "--set", "channel.sides=half", "--set", 'channel.width="86.6 mm"',
                       "--set", "start.kind=section"], CONDUIT | {"vegetation"}),
            "bed": ([bed, *until(0.5), *snapshots, "--set", "channel.sides=half", "--set", 'channel.width="86.6 mm"'], CONDUIT | {"porous"}),
            "gate": ([SOURCE / "cases/checks/gate.toml", "--set", "numerics.spacing=5mm", *until(0.35), *every(snapshot=0.1)],
                     {"free_surface", "no_section_twin", "solids", "moving_solids", "asked", "end", "profiles"}),
            "block": ([SOURCE / "cases/violent/box-3d.toml", "--set", "numerics.spacing=40mm", "--set",
                       "numerics.courant_number=0.1", *until(0.12), *every(snapshot=0.05)],
                      {"three_dimensions", "free_surface", "no_section_twin", "solids", "asked", "end"}),
            "ends": ([SOURCE / "cases/open-ends/uniform.toml", "--set", "numerics.spacing=3mm", "--set", 'channel.length="150 mm"',
                      "--set", "run.average_from=auto", *until(0.7), *snapshots],
                     {"free_surface", "no_section_twin", "closure", "asked", "end", "profiles", "slope", "open_ends", "local_depth", "spheres"}),
        }
        runs["float"] = ([SOURCE / "cases/bodies/floating-box-3d.toml", "--set", "numerics.spacing=10mm", *until(0.05), *every(snapshot=0.02)],
                         {"three_dimensions", "free_surface", "no_section_twin", "solids", "moving_solids", "free_bodies", "asked", "end"})
        runs["slow"] = ([bare, *until(0.02), "--set", 'numerics.pressure_correction_time="0.1 s"', "--set", "numerics.density_relaxation=0.2"],
                        CONDUIT - {"section_twin", "profiles"} | {"no_section_twin", "slow_correction", "density_relaxation"})
        for stepping in ("verlet", "beeman"):
            runs[stepping] = ([bare, *until(0.02), "--set", f"numerics.stepping={stepping}", "--set",
                               "numerics.courant_number=0.2"],
                              CONDUIT - {"section_twin", "profiles"} | {"no_section_twin", stepping})
        cls.conditions = {name: conditions for name, (_, conditions) in runs.items()}
        for name, (arguments, _) in runs.items():
            result = riffle("run", *arguments, "-o", cls.shared / name, "-q")
            assert result.returncode == 0, result.stderr

    def results(self, run):
        return self.shared / run / "results.h5"

    def fields_of(self, run, group):
        """The rows of the table that may stand in a group of a file, by name; of two of one name that which does."""
        path = re.sub(r"^/snapshots/\d+$", "/snapshots/NNNNN", group.name)
        known = self.conditions[run]
        kind = text(group.attrs["kind"]) if path.startswith("/probes/") else ""
        rows = {}
        for table in self.groups:
            if table["path"] == "/probes/NAME" and kind:
                # A grid that is averaged counts its samples, one that is not does not.
                same = table["kind"] == "" or kind in table["kind"].split(", ")
                averaged = any(field["name"] == "samples" for field in table["fields"])
                if not same or (kind == "grid" and table["kind"] and averaged != ("samples" in group)):
                    continue
            elif table["path"] != path:
                continue
            for field in table["fields"]:
                if set(field["written"]) <= known | MAYBE:
                    numbered = ([field["name"][:-1] + "1"] if field["name"].endswith("_N") else [field["name"]])
                    rows |= {name: field for name in numbered}
        return rows

    def groups_in(self, run):
        """Groups of a file that hold datasets or attributes."""
        with h5py.File(self.results(run)) as file:
            found = [file]
            file.visititems(lambda _, item: found.append(item) if isinstance(item, h5py.Group) else None)
            yield from (group for group in found
                        if group.attrs or any(isinstance(item, h5py.Dataset) for item in group.values()))

    def test_what_the_table_says_is_written_and_nothing_else(self):
        seen = set()
        for run in self.conditions:
            for group in self.groups_in(run):
                rows = self.fields_of(run, group)
                datasets = {name for name, item in group.items() if isinstance(item, h5py.Dataset)}
                first = group.name.endswith("00000") or not group.name.startswith("/snapshots/")
                for attribute, found in ((False, datasets), (True, set(group.attrs))):
                    expected = {name: field for name, field in rows.items() if field["attribute"] == attribute}
                    where = f"{run}: {group.name}"
                    self.assertEqual(found - set(expected), set(), f"{where}: written, but not in the table")
                    needed = {name for name, field in expected.items()
                              if not MAYBE & set(field["written"]) and (first or name != "point")}
                    self.assertEqual(needed - found, set(), f"{where}: in the table, but not written")
                    seen |= {(field["name"], rows[name]["meaning"][0]) for name, field in expected.items() if name in found}
                space = "three_dimensions" in self.conditions[run]
                for name in datasets:
                    field = rows[name]
                    self.assertEqual(text(group[name].attrs["units"]), field["unit"][space], f"{group.name}/{name}")
                    meant = re.sub(r' "[^"]*"', "", text(group[name].attrs["long_name"]))
                    self.assertEqual(meant, field["meaning"][space], f"{group.name}/{name}")
                    if group[name].shape:
                        self.assertEqual(group[name].ndim, len(field["axes"]), f"{group.name}/{name}: {field['axes']}")
        missing = {(field["name"], field["meaning"][0]) for table in self.groups for field in table["fields"]
                   if not MAYBE & set(field["written"])} - seen
        self.assertEqual(missing, set(), "in the table, but written by none of the runs")

    def products(self, file):
        """What users see of a results file, one after the other."""
        made = self.folder / "made"

        def said(*arguments):
            made.unlink(missing_ok=True)
            result = riffle(*arguments, made)
            return result.returncode, result.stdout, result.stderr, made.read_text() if made.exists() else ""

        yield said("analyse", file, "--json")
        yield said("report", file, "-o", self.folder / "page.html", "--json")
        yield said("report", file, "-o")
        yield said("analyse", file, "--window", "0.1,0.4", "--json")
        yield self.watched(file)
        yield self.swept(file)

    def watched(self, file):
        process = start("watch", file, "--port", "0")
        try:
            port = int(process.stdout.readline().strip().rstrip("/").rsplit(":", 1)[1])
            connection = http.client.HTTPConnection("127.0.0.1", port, timeout=60)
            connection.request("GET", "/data.json")
            return connection.getresponse().read()
        finally:
            process.kill()
            process.communicate()

    def swept(self, file):
        """What a sweep whose run this is says of it."""
        if file.parent.name != "plane":
            return ""
        folder = self.folder / "sweep"
        arguments = ["sweep", self.shared / "plane.toml", "--vary", "numerics.spacing=2.5mm", "--set", "channel.length=0.06",
                     *until(0.7), *every(snapshot=0.2), "-o", folder, "-q"]
        for outcome in ("depth_mean_velocity", "depth_mean_velocity_error", "total_mean_velocity",
                        "total_mean_velocity_error", "particle_order", "velocity_fluctuation"):
            arguments += ["--outcome", outcome]
        inside = folder / "spacing=2.5mm"
        if not inside.exists():
            self.succeed(*arguments)
        shutil.copyfile(file, inside / "results.h5")
        self.succeed(*arguments)
        return (folder / "sweep.json").read_text()

    def test_each_field_is_read_by_whom_the_table_says(self):
        """A field that the table calls read by the analysis changes what users see when its values change; the others
        change nothing, so that the table does not hide that somebody reads them."""
        read, unread = set(), {}
        for run in ("plane", "space", "gate", "block"):
            plain = self.folder / run / "results.h5"
            plain.parent.mkdir()
            with h5py.File(self.results(run)) as sealed, h5py.File(plain, "w") as file:
                for name in sealed:
                    sealed.copy(name, file)
                for name, value in sealed.attrs.items():
                    file.attrs[name] = value
            before = list(self.products(plain))
            others = []
            for group in self.groups_in(run):
                for name, field in self.fields_of(run, group).items():
                    place = (name, field["attribute"])
                    if not (name in group.attrs if field["attribute"] else name in group) or group.name == "/case":
                        continue
                    key = (self.short_name(group), name)
                    if field["reader"] != "analysis":
                        others.append((group.name, *place))
                    elif key not in read and key not in ELSEWHERE:
                        with changed(plain, [(group.name, *place)]):
                            same = all(a == b for a, b in zip(before, self.products(plain)))
                        (unread.setdefault(key, run) if same else (read.add(key), unread.pop(key, None)))
            with changed(plain, others):
                for one, other in zip(before, self.products(plain)):
                    self.assertEqual(one, other, f"{run}: something reads what the table calls unread")
        self.assertEqual(set(unread), set(), "recorded, but nothing reads it")

    @staticmethod
    def short_name(group):
        """The group; of an instrument its kind, "frames" for a grid that is not averaged."""
        if not group.name.startswith("/probes/"):
            return re.sub(r"^/snapshots/.*", "/snapshots", group.name)
        kind = text(group.attrs["kind"])
        return "frames" if kind == "grid" and "samples" not in group else kind


class changed:
    """Other values for some datasets and attributes of a file, for a while."""

    def __init__(self, path, places):
        self.path, self.places = path, places

    def __enter__(self):
        shutil.copyfile(self.path, self.path.with_suffix(".kept"))
        with h5py.File(self.path, "a") as file:
            for group, name, is_attribute in self.places:
                if is_attribute:
                    value = file[group].attrs[name]
                    file[group].attrs[name] = other(value) if numpy.ndim(value) else other(numpy.array([value]))[0]
                else:
                    data = file[group][name]
                    data[...] = other(data[...])

    def __exit__(self, *_):
        shutil.move(self.path.with_suffix(".kept"), self.path)


def other(values):
    """Other values of the same type and shape, no multiple of these, increasing where these do."""
    values = numpy.asarray(values)
    if values.dtype.kind in "SO":
        return numpy.array([text(value).encode() + b"x" for value in values.ravel()]).reshape(values.shape)
    if values.dtype.kind in "iu":
        return numpy.full_like(values, values.flat[0]) if values.size > 1 else values + 1 - 2 * (values == 1)
    ramp = 1 + 0.05 * (1 + numpy.arange(len(values)).reshape(-1, *[1] * (values.ndim - 1))) / max(1, len(values))
    size = numpy.nanmax(numpy.abs(values)) if values.size and not numpy.isnan(values).all() else 1.0
    return (values * ramp + 0.01 * (size or 1.0) * (ramp - 0.999)).astype(values.dtype)


if __name__ == "__main__":
    main()
