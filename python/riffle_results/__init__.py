"""Opens the results files of Riffle as xarray Datasets, with dimensions, coordinates, units and names.

    from riffle_results import open_results

    with open_results("results/my-flume") as run:
        print(run)                            # what the file holds
        profile = run.profiles.velocity       # an xarray DataArray, read when it is used
        print(run.summary["depth_mean_velocity"], profile.attrs["units"])

It opens files and nothing more: what Riffle measures and analyses is in the files themselves (docs/results-fields.md)
and in what `riffle analyse --json` writes, which `read_analysis` opens.
"""
from .analysis import Analysis, read_analysis
from .errors import ResultsError
from .results import Results, open_results

__all__ = ["Analysis", "Results", "ResultsError", "open_results", "read_analysis"]
