"""Dimensions and coordinates of the groups of a results file (docs/results-format.md)."""

# First dimension of the arrays of a group, and its coordinates.
_LISTS = {
    "time_series": ("time", ["time"]),
    "profiles": ("layer", ["z", "bin_lower", "bin_upper"]),
    "column": ("z", ["z"]),
    "snapshots": ("particle", ["id"]),
    "lost_particles": ("particle", ["id"]),
}

_PLACES = ("x", "y", "z")

# Arrays of a snapshot that are not of its particles, where solids move.
_OF_BOUNDARIES = {"wall_position": ("wall", "axis"), "solid_vertices": ("vertex", "axis")}

# First dimension of the arrays of a group of /boundaries.
_BOUNDARIES = {"walls": "wall", "solids": "vertex", "spheres": "sphere"}

# Dimensions of the fields over places of a group; its arrays of these names are their coordinates.
_FIELDS = {
    "mean_field": ("time", "z", "y", "x"),
    "surface_map": ("time", "y", "x"),
    "section": ("z", "y"),
}


def dimensions(kind, group, arrays):
    """Dimensions of each array by name, and the names of those that are coordinates."""
    if kind == "surface":
        return {name: {"x": ("x",), "time": ("time",)}.get(name, ("time", "x")) for name in arrays}, ["time", "x"]
    if kind == "profile_blocks":
        axes = ("time", "layer", "quantity")
        return {name: axes[:array.ndim] for name, array in arrays.items()}, ["time"]
    if kind in _FIELDS:
        places = _FIELDS[kind]
        axes = [name for name in ("time", *_PLACES) if name in arrays]
        return {name: (name,) if name in axes else places[:array.ndim] for name, array in arrays.items()}, axes
    if kind == "probes":
        return _of_probe(group, arrays)
    if kind == "boundaries":
        first = _BOUNDARIES[group.name.rsplit("/", 1)[-1]]
        return {name: ("triangle", "corner") if name == "triangles" else (first, "axis")[:array.ndim]
                for name, array in arrays.items()}, []
    first, coordinates = _LISTS[kind]
    return {name: _OF_BOUNDARIES.get(name, (first, "axis"))[:array.ndim] for name, array in arrays.items()}, coordinates


def _of_probe(group, arrays):
    """The axes of an instrument are its arrays x, y, z; all else has a row per time. Rows of one number per point have
    the dimension `point`, or x where that alone gives the places; rows of a plane have the axes x and z as dimensions
    (in three dimensions the plane's place y is an axis of length one)."""
    axes = [name for name in _PLACES if name in arrays]
    rows = {name: array for name, array in arrays.items() if name not in axes}
    grid = any(array.ndim > 2 for array in rows.values())
    if grid:
        places = tuple(name for name in reversed(axes) if name != "y")  # (z, x): x runs fastest
    else:
        places = ("point",) if len(axes) > 1 else tuple(axes)
    result = {name: (name,) if grid or len(axes) == 1 else ("point",) for name in axes}
    for name, array in rows.items():
        if array.ndim > 1 + len(places):
            raise ValueError(f"{group.name}/{name} has {array.ndim} dimensions; the probe's places {axes} explain {1 + len(places)}")
        result[name] = ("time", *places)[:array.ndim]
    return result, ["time", *axes]


def with_names(kind, dataset):
    """The dataset with coordinates that name its axes, where the file gives them otherwise."""
    if kind in ("snapshots", "boundaries") and "axis" in dataset.dims:
        return dataset.assign_coords(axis=["x", "y", "z"])
    if kind == "profile_blocks" and "quantities" in dataset.attrs:
        return dataset.assign_coords(quantity=dataset.attrs.pop("quantities").split())
    return dataset
