#!/usr/bin/python3
"""Open DIR/results.xdmf with the XDMF readers of ParaView and compare what they show with DIR/results.h5.

Usage: check_xdmf.py DIR

Compares the times, the number of particles, the points and each array of each snapshot, value by value.
Exit status: 0 everything agrees, 1 something differs, 77 a reader or h5py is not installed (packages python3-paraview,
python3-h5py; the Python of Debian, /usr/bin/python3, has them).
"""
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
POSITION = "position"


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
                arrays[f"{name}/field/{field}"] = data[...]
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
    return [snapshots[name] for name in sorted(snapshots)]


def leaf(data):
    """The one grid in what a reader gives, which may lie in nested blocks."""
    while data is not None and data.IsA("vtkMultiBlockDataSet"):
        blocks = [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())]
        blocks = [block for block in blocks if block is not None]
        assert len(blocks) == 1, f"{len(blocks)} grids at one time instead of one"
        data = blocks[0]
    assert data is not None, "no grid"
    return data


def check_reader(reader, path, reference):
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkCommand
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

    problems = []
    reader.AddObserver(vtkCommand.ErrorEvent, lambda *_: problems.append("the reader reports an error"))
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    information = reader.GetOutputInformation(0)
    times = [float(t) for t in information.Get(Pipeline.TIME_STEPS()) or []]
    assert times == [float(s["time"]) for s in reference], f"times {times}"
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
    reference = load_reference(folder / "results.h5")
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
        except AssertionError as error:
            print(f"{make_reader.__name__}: {error}")
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
