"""Dimensions and coordinates of the groups of a results file, as the table of its fields says them: fields.json, made by
`riffle schema --results -o python/riffle_results/fields.json`."""
import json
import re
from importlib.resources import files

_AXES = {group["path"]: {field["name"]: tuple(field["axes"]) for field in group["fields"] if not field["attribute"]}
         for group in json.loads(files(__package__).joinpath("fields.json").read_text(encoding="utf-8"))["groups"]
         if not group["kind"]}

# Coordinates beside the arrays that are axes of their group.
_COORDINATES = {"/profiles": ["z", "bin_lower", "bin_upper"], "/snapshots/NNNNN": ["id"], "/lost_particles": ["id"]}


def dimensions(kind, group, arrays):
    """Dimensions of each array by name, and the names of those that are coordinates."""
    if kind == "probes":
        return _of_probe(group, arrays)
    path = re.sub(r"^/snapshots/.*", "/snapshots/NNNNN", group.name)
    axes = _AXES[path]
    unknown = {name: tuple(f"{name}_{k}" for k in range(array.ndim)) for name, array in arrays.items() if name not in axes}
    return ({name: axes[name] for name in arrays if name in axes} | unknown,
            [name for name in arrays if axes.get(name) == (name,)] + _COORDINATES.get(path, []))


def _of_probe(group, arrays):
    """The axes of an instrument are its arrays x, y, z; all else has a row per time. Rows of one number per point have
    the dimension `point`, or x where that alone gives the places; rows of a plane have the axes x and z as dimensions
    (in three dimensions the plane's place y is an axis of length one)."""
    axes = [name for name in ("x", "y", "z") if name in arrays]
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
