"""What gives a class its face in a notebook; a terminal has its repr()."""

import importlib


class Shown:
    def _repr_html_(self):
        """HTML for a notebook. Figures are made here alone: matplotlib takes longer to load than all the rest."""
        return importlib.import_module(".things", __package__).html_of(self)
