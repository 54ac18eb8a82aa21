"""What `riffle analyse --json` writes."""
import json
from dataclasses import dataclass
from pathlib import Path

import numpy
import pandas
import xarray

from .errors import ResultsError

FORMAT = "riffle-analysis"
VERSION = 1  # analysis_json_version of src/analysis/analysis_json.hpp


def read_analysis(path):
    """The analyses of a file that `riffle analyse --json` wrote, one per results file or laboratory record. Raises
    ResultsError."""
    path = Path(path)
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise ResultsError(f"{path}: there is no such file; expected one that `riffle analyse --json` wrote") from None
    except (OSError, ValueError) as error:
        raise ResultsError(f"{path}: cannot be read as JSON: {error}") from error
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise ResultsError(f"{path}: is not an analysis of Riffle (its `format` is not {FORMAT!r}); expected what "
                           "`riffle analyse --json` writes")
    if content.get("format_version") != VERSION:
        raise ResultsError(f"{path}: has analysis format version {content.get('format_version')} (written by Riffle "
                           f"{content.get('riffle_version')}); this package reads version {VERSION}; use the package that "
                           "came with that Riffle")
    return [Analysis(**{name: each[name] for name in ("name", "source", "warnings")}, _findings=each["findings"],
                     _figures={figure["key"]: figure for figure in each["figures"]}) for each in content["analyses"]]


@dataclass(frozen=True)
class Analysis:
    """All that was found in one results file or laboratory record. SI units."""

    name: str
    source: str
    warnings: list
    _findings: list
    _figures: dict

    @property
    def findings(self):
        """The numbers found, a DataFrame by key: chapter, label, value, half_width (of the 95 % interval), reference,
        reference_name, unit, remark."""
        columns = ["key", "chapter", "label", "value", "half_width", "reference", "reference_name", "unit", "remark"]
        frame = pandas.DataFrame([{name: finding.get(name) for name in columns} for finding in self._findings],
                                 columns=columns)
        numbers = ["value", "half_width", "reference"]
        frame[numbers] = frame[numbers].astype(float)
        return frame.set_index("key")

    @property
    def figure_keys(self):
        """Keys of the figures."""
        return list(self._figures)

    def figure(self, key):
        """A figure as the file has it: title, caption, source, x, y (axes: label, unit, logarithmic), curves, maps, and in
        `missing` why there is nothing to draw."""
        if key not in self._figures:
            raise ResultsError(f"{self.source}: the analysis has no figure {key!r}; it has {', '.join(self._figures)}")
        return self._figures[key]

    def curves(self, key):
        """The curves of a figure below each other, a DataFrame: name, origin, run, x, y, x_half_width, y_half_width."""
        columns = ["name", "origin", "run", "x", "y", "x_half_width", "y_half_width"]
        frames = [pandas.DataFrame({"name": curve["name"], "origin": curve["origin"], "run": curve["run"],
                                    **{name: _numbers(curve[name], len(curve["x"])) for name in columns[3:]}})
                  for curve in self.figure(key)["curves"]]
        return pandas.concat(frames, ignore_index=True) if frames else pandas.DataFrame(columns=columns)

    def maps(self, key):
        """The maps of a figure, DataArrays over (y, x) with the units and names of its axes."""
        figure = self.figure(key)
        result = []
        for each in figure["maps"]:
            x, y = _numbers(each["x"], len(each["x"])), _numbers(each["y"], len(each["y"]))
            values = _numbers(each["values"], x.size * y.size).reshape(y.size, x.size)
            result.append(xarray.DataArray(
                values, dims=("y", "x"), name=each["label"],
                coords={axis: (axis, at, {"units": figure[axis]["unit"], "long_name": figure[axis]["label"]})
                        for axis, at in (("x", x), ("y", y))},
                attrs={"units": each["unit"], "long_name": each["label"], "run": each["run"]}))
        return result


def _numbers(values, count):
    """A list of numbers and nulls as an array; where nothing is known, not-a-number throughout."""
    return numpy.array(values if values else [None] * count, dtype=float)
