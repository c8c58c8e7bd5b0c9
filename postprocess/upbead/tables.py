"""Results as tables of pandas and data sets of xarray, with their units. Both packages are read on use only."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from . import told
from .errors import UpbeadError
from .history import History

if TYPE_CHECKING:
    import pandas
    import xarray


class MissingPackage(UpbeadError, ImportError):
    """A package that only this call needs is not installed."""


def needed(name: str, call: str) -> Any:
    """The module, or an error that says what to install."""
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError as error:
        raise MissingPackage(f"{call} needs {error.name}: pip install {error.name} (Debian: python3-{error.name})") from error


def about(title: str, summary: Mapping[str, Any]) -> dict[str, str]:
    """What a table says of itself: its title, and why no verdict may be drawn of its numbers."""
    why = told.void(summary)
    return {"title": title, **({"void": why} if why else {})}


def unit_of(values: Any) -> str:
    return str(getattr(values, "unit", ""))


def data_frame(columns: Mapping[str, Any], index: str | None = None, about: Mapping[str, Any] | None = None) -> pandas.DataFrame:
    """A DataFrame of columns of one length; its `attrs` have `units` and `descriptions` by column, and what is `about` it."""
    library = needed("pandas", "to_pandas()")
    frame: pandas.DataFrame = library.DataFrame({name: np.asarray(values) for name, values in columns.items()})
    if index is not None:
        frame = frame.set_index(index)
    frame.attrs["units"] = {name: unit_of(values) for name, values in columns.items()}
    frame.attrs["descriptions"] = {name: str(getattr(values, "description", "")) for name, values in columns.items()}
    frame.attrs.update(about or {})
    return frame


def data_set(variables: Mapping[str, tuple[tuple[str, ...], Any]], coordinates: Mapping[str, Any], about: Mapping[str, Any]) -> xarray.Dataset:
    """A Dataset of {name: (dimensions, values)}; `units` and `long_name` are attributes of each variable, as of the CF conventions."""
    library = needed("xarray", "to_xarray()")

    def variable(dimensions: tuple[str, ...], values: Any) -> Any:
        marks = {"units": unit_of(values), "long_name": str(getattr(values, "description", ""))}
        return dimensions, np.asarray(values), {key: mark for key, mark in marks.items() if mark}

    found: xarray.Dataset = library.Dataset({name: variable(dimensions, values) for name, (dimensions, values) in variables.items()},
                          {name: variable((name,), values) for name, values in coordinates.items()}, dict(about))
    return found


def long_columns(table: Mapping[str, History], time: History) -> dict[str, Any]:
    """The columns of a table over time and place, a row for each pair: those of the two axes first."""
    places = {name: values for name, values in table.items() if values.ndim == 1 and values.size != time.size}
    fields = {name: values for name, values in table.items() if values.ndim == 2}
    if not fields:
        return dict(table)
    size = next(iter(fields.values())).shape[1]
    columns: dict[str, Any] = {"time": History(np.repeat(time, size), unit_of(time), time.description)}
    columns |= {name: History(np.tile(values, time.size), values.unit, values.description) for name, values in places.items() if values.size == size}
    return columns | {name: History(np.asarray(values).ravel(), values.unit, values.description) for name, values in fields.items()}
