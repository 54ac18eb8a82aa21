#!/usr/bin/python3
"""Open DIR/results.xdmf, and DIR/boundaries.xdmf and DIR/mean_field.xdmf where there are any, with the XDMF readers of
ParaView and compare what they show with DIR/results.h5.

Usage: check_xdmf.py DIR

Compares the times, the number of particles, the points and each array of each snapshot, the points of walls, solids and
spheres, and the times, the grid and each
array of each window of the mean field, value by value.
Exit status: 0 everything agrees, 1 something differs, 77 a reader or h5py is not installed (packages python3-paraview,
python3-h5py; the Python of Debian, /usr/bin/python3, has them).
"""
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
POSITION = "position"
FOR_THE_INDEX = {"point", "wall_position", "solid_vertices"}  # datasets of a snapshot that are no arrays of its particles
FIELD = "mean_field"
BOUNDARIES = "boundaries"


def write_reference(results, target):
    """The snapshots of the results file as a NumPy archive. A process of its own runs this: ParaView and h5py
    bring different builds of the HDF5 library."""
    import h5py
    import numpy

    arrays = {}
    with h5py.File(results, "r") as file:
        for name, group in file["snapshots"].items():
            arrays[f"{name}/time"] = group.attrs["time"]
            for field, data in group.items():
                if field not in FOR_THE_INDEX:
                    arrays[f"{name}/field/{field}"] = data[...]
        bodies = file.get(BOUNDARIES, {})
        moved = sorted(file["snapshots"])[-1:] if "snapshots" in file else []
        for name, path in (("walls", "walls/position"), ("solids", "solids/vertices"), ("spheres", "spheres/centre")):
            last = {"walls": "wall_position", "solids": "solid_vertices"}.get(name)
            if path in bodies:
                now = [file["snapshots"][group][last] for group in moved if last in file["snapshots"][group]] if last else []
                arrays[f"{BOUNDARIES}/field/{name}"] = (now or [bodies[path]])[0][...]
        for name, data in file.get(FIELD, {}).items():
            arrays[f"{FIELD}/field/{name}"] = data[...]
    numpy.savez(target, **arrays)


def load_reference(results):
    import numpy

    with tempfile.TemporaryDirectory() as folder:
        archive = Path(folder) / "reference.npz"
        code = subprocess.run([sys.executable, __file__, "--reference", results, archive]).returncode
        if code != 0:
            sys.exit(code)
        with numpy.load(archive) as data:
            snapshots = {}
            for key, value in data.items():
                name, _, field = key.partition("/")
                snapshots.setdefault(name, {})[field.removeprefix("field/")] = value
    field, boundaries = snapshots.pop(FIELD, None), snapshots.pop(BOUNDARIES, None)
    return [snapshots[name] for name in sorted(snapshots)], field, boundaries


def leaf(data):
    """The one grid in what a reader gives, which may lie in nested blocks."""
    while data is not None and data.IsA("vtkMultiBlockDataSet"):
        blocks = [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())]
        blocks = [block for block in blocks if block is not None]
        assert len(blocks) == 1, f"{len(blocks)} grids at one time instead of one"
        data = blocks[0]
    assert data is not None, "no grid"
    return data


def open_index(reader, path, expected_times):
    """Times that the reader finds in the index, and the list that its error messages will be added to."""
    from vtkmodules.vtkCommonCore import vtkCommand
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

    problems = []
    reader.AddObserver(vtkCommand.ErrorEvent, lambda *_: problems.append("the reader reports an error"))
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    information = reader.GetOutputInformation(0)
    times = [float(t) for t in information.Get(Pipeline.TIME_STEPS()) or []]
    assert times == [float(t) for t in expected_times], f"times {times}"
    return times, problems


def check_field(reader, path, reference):
    """The windows of the mean field: cells between the centres, values in them."""
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy

    axes = ("x", "y", "z")
    fields = set(reference) - {*axes, "time", "samples"}
    times, problems = open_index(reader, path, reference["time"])
    for row, time in enumerate(times):
        reader.UpdateTimeStep(time)
        grid = leaf(reader.GetOutputDataObject(0))
        assert grid.IsA("vtkRectilinearGrid"), f"a {grid.GetClassName()}"
        for name, coordinates in zip(axes, (grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates())):
            edges = vtk_to_numpy(coordinates)
            centres = (edges[1:] + edges[:-1]) / 2
            assert numpy.allclose(centres, reference[name], rtol=1e-6, atol=1e-9), f"cells along {name} differ"
        names = {grid.GetCellData().GetArrayName(i) for i in range(grid.GetCellData().GetNumberOfArrays())}
        assert names == fields, f"arrays {sorted(names)}, not {sorted(fields)}, at {time} s"
        for name in fields:
            shown = vtk_to_numpy(grid.GetCellData().GetArray(name))
            assert numpy.array_equal(shown, reference[name][row].ravel(), equal_nan=True), f"array {name} differs at {time} s"
    assert not problems, problems[0]
    return len(times)


def leaves(data):
    """All grids in what a reader gives."""
    if data is None:
        return []
    if not data.IsA("vtkMultiBlockDataSet"):
        return [data]
    return [grid for i in range(data.GetNumberOfBlocks()) for grid in leaves(data.GetBlock(i))]


def check_boundaries(reader, path, reference):
    """Walls, solids and spheres at the last time: their points, each of them drawn."""
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

    reader.SetFileName(str(path))
    reader.UpdateInformation()
    times = reader.GetOutputInformation(0).Get(Pipeline.TIME_STEPS())
    if times:
        reader.UpdateTimeStep(float(times[-1]))
    else:
        reader.Update()
    grids = leaves(reader.GetOutputDataObject(0))
    shown = [vtk_to_numpy(grid.GetPoints().GetData()) for grid in grids]
    assert len(grids) == len(reference), f"{len(grids)} grids, not {sorted(reference)}"
    for name, points in reference.items():
        assert any(each.shape == points.shape and numpy.allclose(each, points, atol=1e-7) for each in shown), f"{name} differ"
    assert all(grid.GetNumberOfCells() > 0 for grid in grids), "a grid without cells"
    return len(grids)


def check_reader(reader, path, reference):
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy

    times, problems = open_index(reader, path, [s["time"] for s in reference])
    for time, snapshot in zip(times, reference):
        reader.UpdateTimeStep(time)
        grid = leaf(reader.GetOutputDataObject(0))
        particles = len(snapshot[POSITION])
        assert grid.GetNumberOfPoints() == particles, f"{grid.GetNumberOfPoints()} points, not {particles}, at {time} s"
        assert grid.GetNumberOfCells() > 0, f"nothing to draw at {time} s"
        drawn = set()
        for cell in range(grid.GetNumberOfCells()):
            ids = grid.GetCell(cell).GetPointIds()
            drawn.update(ids.GetId(i) for i in range(ids.GetNumberOfIds()))
        assert len(drawn) == particles, f"{len(drawn)} of {particles} points are drawn at {time} s"
        points = vtk_to_numpy(grid.GetPoints().GetData())
        assert numpy.array_equal(points, snapshot[POSITION].astype(points.dtype)), f"points differ at {time} s"
        names = {grid.GetPointData().GetArrayName(i) for i in range(grid.GetPointData().GetNumberOfArrays())}
        expected = set(snapshot) - {"time", POSITION}
        assert names == expected, f"arrays {sorted(names)}, not {sorted(expected)}, at {time} s"
        for name in expected:
            shown = vtk_to_numpy(grid.GetPointData().GetArray(name))
            assert numpy.array_equal(shown, snapshot[name]), f"array {name} differs at {time} s"
    assert not problems, problems[0]
    return len(reference)


def main():
    if len(sys.argv) == 4 and sys.argv[1] == "--reference":
        try:
            write_reference(sys.argv[2], sys.argv[3])
        except ImportError as error:
            print(f"skipped: {error} (package python3-h5py)")
            return SKIPPED
        return 0
    if len(sys.argv) != 2:
        print(__doc__)
        return 2
    folder = Path(sys.argv[1]).resolve()  # the XDMF 3 reader needs the folder to find the HDF5 file
    reference, field, boundaries = load_reference(folder / "results.h5")
    try:
        from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
        from vtkmodules.vtkIOXdmf3 import vtkXdmf3Reader
    except ImportError as error:
        print(f"skipped: {error} (package python3-paraview; the VTK of python3-vtk9 reads no XDMF)")
        return SKIPPED
    status = 0
    for make_reader in (vtkXdmfReader, vtkXdmf3Reader):
        try:
            count = check_reader(make_reader(), folder / "results.xdmf", reference)
            print(f"{make_reader.__name__}: {count} snapshots agree with results.h5")
            if boundaries is not None and (folder / "boundaries.xdmf").exists():
                count = check_boundaries(make_reader(), folder / "boundaries.xdmf", boundaries)
                print(f"{make_reader.__name__}: {count} kinds of boundaries agree with results.h5")
            # The XDMF 3 reader shows no part of a dataset, of which each window is one.
            if make_reader is vtkXdmfReader and field is not None and len(field["time"]) > 0:
                count = check_field(make_reader(), folder / "mean_field.xdmf", field)
                print(f"{make_reader.__name__}: {count} windows of the mean field agree with results.h5")
        except AssertionError as error:
            print(f"{make_reader.__name__}: {error}")
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
