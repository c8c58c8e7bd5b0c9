"""Gives a class its display in a notebook; a terminal shows its repr()."""

from __future__ import annotations

import importlib


class Shown:
    def _repr_html_(self) -> str:
        """HTML for a notebook. Figures are made only here, as matplotlib takes longer to load than the rest of the
        package."""
        return str(importlib.import_module(".things", __package__).html_of(self))
