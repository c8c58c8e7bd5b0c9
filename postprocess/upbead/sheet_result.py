"""The results of `upbead sheet`: the checks of formulas, of the run and of the life in one summary."""

from __future__ import annotations

from .named import Named
from .results import Folder, read_summary


class SheetSummary(Named):
    """The summary as a dict, with the summaries of `waves`, `run` and `expected` in it."""

    def __repr__(self) -> str:
        return f"<SheetSummary '{self.get('title', '')}': {(self.get('verdict') or {}).get('text', '')}>"


def read_sheet(folder: Folder) -> SheetSummary:
    return SheetSummary(read_summary(folder))
