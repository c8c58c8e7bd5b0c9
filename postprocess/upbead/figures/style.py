"""Style of the figures, and how they are made without a window."""

from __future__ import annotations

import functools
import io
from collections.abc import Callable
from os import PathLike
import re
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

import matplotlib
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from .. import prefixes
from ..errors import UserError
from .doubt import mark

Given = ParamSpec("Given")
Made = TypeVar("Made")
STYLE = {
    "font.size": 9,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
}
SYMBOL = re.compile(r"(?<![A-Za-z0-9_])([A-Za-z])_([A-Za-z0-9]{1,3})(?![A-Za-z0-9_])")


class ResultFigure(Figure):  # type: ignore[misc]  # matplotlib 3.6 has no types
    """A matplotlib figure that a notebook shows, and that pyplot does not keep."""

    def draw(self, renderer: Any) -> None:
        with matplotlib.rc_context(STYLE):  # ticks are made only when the figure is drawn
            super().draw(renderer)

    def _repr_png_(self) -> bytes:
        return render(self)


def render(figure: Figure, dpi: float = 100) -> bytes:
    """The figure as the bytes of a PNG, cropped to its content."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=dpi, bbox_inches="tight")
    return buffer.getvalue()


def new_figure(figsize: tuple[float, float], layout: str | None = None) -> ResultFigure:
    figure = ResultFigure(figsize=figsize, layout=layout)
    FigureCanvasAgg(figure)
    return figure


def subplots(rows: int = 1, columns: int = 1, *, figsize: tuple[float, float], layout: str | None = None, **options: Any) -> Any:
    """As pyplot.subplots, with a ResultFigure."""
    figure = new_figure(figsize, layout)
    return figure, figure.subplots(rows, columns, **options)


def mosaic(places: Any, *, figsize: tuple[float, float], layout: str | None = None) -> Any:
    """As pyplot.subplot_mosaic, with a ResultFigure."""
    figure = new_figure(figsize, layout)
    return figure, figure.subplot_mosaic(places)


def styled(draw: Callable[Given, Made]) -> Callable[Given, Made]:
    """A function that makes a figure in the style above, whatever the style of the caller, and with the mark of what it is drawn of."""

    @functools.wraps(draw)
    def drawn(*arguments: Given.args, **options: Given.kwargs) -> Made:
        with matplotlib.rc_context(STYLE):
            figure = draw(*arguments, **options)
            if figure is not None:  # nothing to draw
                mark(figure, [*arguments, *options.values()])
            return figure

    return drawn


def plain(text: object) -> str:
    """A user's text unchanged: no mathematics between $ and $, and not left out of a legend because of a leading
    _."""
    text = str(text).replace("$", r"\$")
    return f" {text}" if text.startswith("_") else text


def mathematics(words: str) -> str:
    """A text with its symbols set by matplotlib: x_G, F_T."""
    return SYMBOL.sub(r"$\1_{\\mathrm{\2}}$", plain(words))


def scaled(unit: str, peak: float) -> tuple[float, str]:
    """(factor, unit to write) with the prefix that suits the largest value, as in the reports."""
    factor, name = prefixes.scale(unit, peak, 10.0)
    return factor, prefixes.pretty(name)


def save(figure: Figure, path: str | PathLike[str]) -> None:
    """Writes the figure in the format of the file's ending (.png, .pdf, .svg)."""
    path = Path(path)
    known = figure.canvas.get_supported_filetypes()
    if path.suffix.lstrip(".").lower() not in known:
        raise UserError(f"'{path}': unknown format '{path.suffix}'; use .png, .pdf or .svg")
    try:
        figure.savefig(path, bbox_inches="tight", dpi=150)
    except OSError as error:
        raise UserError(f"cannot write '{path}': {error.strerror}") from error
