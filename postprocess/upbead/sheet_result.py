"""The results of `upbead sheet`: the checks of formulas, of the run and of the life in one summary."""

from .results import read_summary


class SheetSummary(dict):
    """The summary as a dict, with the summaries of `waves`, `run` and `expected` in it."""

    def __repr__(self):
        return f"<SheetSummary '{self.get('title', '')}': {(self.get('verdict') or {}).get('text', '')}>"


def read_sheet(folder):
    return SheetSummary(read_summary(folder))
