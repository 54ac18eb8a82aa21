"""Arrays that stay in the HDF5 file until they are used."""
import numpy
import xarray
from xarray.backends import BackendArray
from xarray.core import indexing


class _FileArray(BackendArray):
    """An HDF5 dataset, as xarray reads from files."""

    def __init__(self, dataset):
        self._dataset = dataset
        self.shape = dataset.shape
        self.dtype = dataset.dtype

    def __getitem__(self, key):
        # Only what slices and numbers say is asked of HDF5; xarray does the rest in memory.
        return indexing.explicit_indexing_adapter(key, self.shape, indexing.IndexingSupport.BASIC, self._read)

    def _read(self, key):
        if not self._dataset:
            raise ValueError("the results file has been closed; read what you need (Dataset.load()) before, or keep it open")
        return numpy.asarray(self._dataset[key])


def lazy_variable(dimensions, dataset):
    """The dataset as an xarray Variable with its attributes (units, long_name), read part by part when it is used and
    then kept."""
    array = indexing.LazilyIndexedArray(_FileArray(dataset))
    attributes = {name: plain(value) for name, value in dataset.attrs.items()}
    return xarray.Variable(dimensions, indexing.MemoryCachedArray(indexing.CopyOnWriteArray(array)), attributes)


def plain(value):
    """An HDF5 attribute as a Python number or text, or as a NumPy array."""
    if isinstance(value, bytes):
        return value.decode()
    if isinstance(value, numpy.ndarray):
        return plain(value[()]) if value.ndim == 0 else value
    return value.item() if isinstance(value, numpy.generic) else value
