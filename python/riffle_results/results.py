"""Results files."""
import time
import tomllib
from pathlib import Path

import xarray

try:
    import h5py
except ImportError as error:
    raise ImportError("riffle_results needs h5py: apt-get install python3-h5py, or pip install h5py") from error

from . import layout
from .errors import ResultsError
from .lazy import lazy_variable, plain

FORMAT = "riffle-results"
PATIENCE = 5.0  # with a run that is changing the file, s
VERSION = 1  # results_format_version of src/output/results_file.hpp


def open_results(path):
    """Open a results file: `path` names it, or the folder of a run that holds it as results.h5. A file of any size opens
    at once; arrays are read when they are used. Of a run in progress it is the state at this moment: Riffle leaves a
    file that somebody reads as it is, so open it again for newer results. Raises ResultsError."""
    path = Path(path)
    if path.is_dir():
        folder, path = path, path / "results.h5"
        if not path.exists():
            raise ResultsError(f"{folder}: no results.h5 in this folder; expected one that `riffle run -o` filled")
    if not path.exists():
        raise ResultsError(f"{path}: there is no such file; expected the results.h5 of a run, or its folder")
    if not h5py.is_hdf5(path):
        raise ResultsError(f"{path}: is not an HDF5 file, or its beginning is damaged; expected the results.h5 of a run")
    try:
        file = _open(path)
    except OSError as error:
        raise ResultsError(f"{path}: cannot be opened: {error}. It is truncated or damaged, or may not be read; restore it "
                           "from a copy, or run the case again") from error
    try:
        _check_format(path, file.attrs)
    except Exception:
        file.close()
        raise
    return Results(path, file)


def _open(path):
    """The file as h5py opens it. A run that changes a large file has it locked for some milliseconds."""
    deadline = time.monotonic() + PATIENCE
    while True:
        try:
            return h5py.File(path, "r")
        except OSError as error:
            if "lock" not in str(error) or time.monotonic() > deadline:
                raise
            time.sleep(0.05)


def _check_format(path, attributes):
    kind = plain(attributes.get("format", ""))
    if kind != FORMAT:
        raise ResultsError(f"{path}: is an HDF5 file, but not a results file of Riffle (its attribute `format` is {kind!r}, "
                           f"not {FORMAT!r}); expected the results.h5 of a run")
    version = plain(attributes.get("format_version", "missing"))
    if version != VERSION:
        writer = plain(attributes.get("riffle_version", "unknown"))
        newer = isinstance(version, int) and version > VERSION
        todo = "use the package that came with that Riffle" if newer else "run the case again (it is in /case/text)"
        raise ResultsError(f"{path}: has results format version {version} (written by Riffle {writer}); this package reads "
                           f"version {VERSION}; {todo}")


class Results:
    """An open results file. Datasets are xarray's, with the units and names of docs/results-fields.md, SI throughout;
    heights are above the bed level. To be closed: use it in a `with` statement."""

    def __init__(self, path, file):
        self.path = path
        self._file = file

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Close the file. Of the Datasets, only what has been used (or `.load()`ed) stays."""
        self._file.close()

    def __repr__(self):
        if not self._file:
            return f"<riffle results {self.path}, closed>"
        parts = [name for name in ("time_series", "profiles", "profile_blocks", "mean_field", "surface", "surface_map", "column",
                                   "section", "lost_particles") if name in self._file]
        return (f"<riffle results {self.path}\n  title: {self.title}\n  complete: {self.complete}\n"
                f"  datasets: {', '.join(parts)}\n  snapshots: {len(self.snapshot_names)}\n"
                f"  probes: {', '.join(self.probe_names) or 'none'}>")

    # The run

    @property
    def attributes(self):
        """Attributes of the file: title, riffle_version, build, created, complete ..."""
        return self._attributes("/")

    @property
    def title(self):
        return self.attributes.get("title", "")

    @property
    def complete(self):
        """Whether the run has come to its end."""
        return bool(self.attributes.get("complete", 0))

    @property
    def summary(self):
        """The numbers of the run by name (docs/results-fields.md, "Summary")."""
        return self._attributes("summary")

    @property
    def case_text(self):
        """The complete case (TOML) that repeats the run."""
        return self._group("case")["text"][()].decode()

    @property
    def case(self):
        """The case by section and key, values as written (lengths may be texts with units)."""
        return tomllib.loads(self.case_text)

    # What it measured

    @property
    def time_series(self):
        """Quantities of the whole flow over `time`."""
        return self._dataset("time_series")

    @property
    def profiles(self):
        """Time means over `layer`, with the coordinates z (mean height of the particles), bin_lower, bin_upper; the
        averaging window is in the attributes. Missing until the averages begin."""
        return self._dataset("profiles")

    @property
    def profile_blocks(self):
        """Sums over blocks of time, from which profiles over any window can be made: `sums` over (time, layer, quantity)."""
        return self._dataset("profile_blocks")

    @property
    def surface(self):
        """Elevation of the free surface over (time, x)."""
        return self._dataset("surface")

    @property
    def mean_field(self):
        """Three dimensions: time means in cells over (time, z, y, x), `time` being the end of each averaging window.
        Missing until the first window ends."""
        return self._dataset("mean_field")

    @property
    def surface_map(self):
        """Three dimensions: elevation of the free surface over (time, y, x)."""
        return self._dataset("surface_map")

    @property
    def section(self):
        """Three dimensions with side walls: the cross-section twin over (z, y); its summary is in the attributes."""
        return self._dataset("section")

    @property
    def column(self):
        """The column twin over z; its summary is in the attributes."""
        return self._dataset("column")

    @property
    def snapshot_names(self):
        """Names of the snapshots, in the order of time."""
        return sorted(self._file["snapshots"]) if "snapshots" in self._file else []

    @property
    def snapshot_times(self):
        """Their times, s."""
        return [float(self._file["snapshots"][name].attrs["time"]) for name in self.snapshot_names]

    def snapshot(self, index=-1):
        """The particles of a snapshot (a number in the order of time, negative from the end, or a name) over `particle`,
        with vectors over `axis`; the coordinate `time` is its instant."""
        names = self.snapshot_names
        try:
            name = index if isinstance(index, str) else names[index]
            group = self._file["snapshots"][name]
        except (IndexError, KeyError):
            raise ResultsError(f"{self.path}: has no snapshot {index!r}; it has {len(names)} "
                               "([output] snapshot_interval sets how often one is kept)") from None
        dataset = self._read(group, "snapshots")
        time = dataset.attrs.pop("time", None)
        return dataset.assign_coords(time=xarray.Variable((), time, {"units": "s", "long_name": "simulated time"}))

    @property
    def probe_names(self):
        """Names of the instruments that recorded ([[probe]], and the standard ones)."""
        return sorted(self._file["probes"]) if "probes" in self._file else []

    def probe(self, name):
        """What an instrument recorded, over `time` and its places; kind, sampling_frequency and standard are in the
        attributes."""
        if name not in self.probe_names:
            raise ResultsError(f"{self.path}: has no probe {name!r}; it has {', '.join(self.probe_names) or 'none'}")
        return self._read(self._file["probes"][name], "probes")

    @property
    def lost_particles(self):
        """The particles that left the domain, over `particle`: when, where, by which way out, with which velocity."""
        return self._dataset("lost_particles")

    @property
    def boundary_names(self):
        """What bounds the water: "walls", and where there are any "solids" and "spheres"."""
        return sorted(self._file["boundaries"]) if "boundaries" in self._file else []

    def boundary(self, name):
        """The particles of the walls over `wall`, the corners of the solids over `vertex` (names in the attributes, a line
        each; triangles in three dimensions) or the bed's spheres over `sphere`, at t = 0."""
        if name not in self.boundary_names:
            raise ResultsError(f"{self.path}: has no boundary {name!r}; it has {', '.join(self.boundary_names) or 'none'}")
        return self._read(self._file["boundaries"][name], "boundaries")

    def _group(self, name):
        if name not in self._file:
            raise ResultsError(f"{self.path}: has no {name} (yet); it has {', '.join(sorted(self._file))}")
        return self._file[name]

    def _attributes(self, group):
        return {name: plain(value) for name, value in self._group(group).attrs.items()}

    def _dataset(self, name):
        return self._read(self._group(name), name)

    def _read(self, group, kind):
        arrays = {name: item for name, item in group.items() if isinstance(item, h5py.Dataset) and item.shape is not None}
        dimensions, coordinates = layout.dimensions(kind, group, arrays)
        variables = {name: lazy_variable(dimensions[name], array) for name, array in arrays.items()}
        dataset = xarray.Dataset(variables, attrs={name: plain(value) for name, value in group.attrs.items()})
        dataset = dataset.set_coords([name for name in coordinates if name in variables])
        return layout.with_names(kind, dataset)
