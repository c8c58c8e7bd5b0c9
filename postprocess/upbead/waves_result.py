"""The results of `upbead waves`: a summary, with an object for each wave."""

import json
from pathlib import Path

from .errors import UserError
from .shown import Shown


class WavesSummary(Shown, dict):
    """The summary as a dict, shown in a notebook as a table with a figure."""

    def __repr__(self):
        names = list(self["waves"])
        told = ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")
        return f"<WavesSummary '{self.get('title', '')}': waves {told}>"


def read_waves(path):
    """The summary of a folder or of a summary.json, with its waves."""
    path = Path(path)
    file = path / "summary.json" if path.is_dir() else path
    try:
        summary = json.loads(file.read_text(encoding="utf-8"))
    except OSError as error:
        raise UserError(f"cannot read '{file}': {error.strerror}") from error
    except ValueError as error:
        raise UserError(f"'{file}' is no JSON: {error}") from error
    if not isinstance(summary, dict) or not summary.get("waves") or "section" not in summary:
        raise UserError(f"'{file}' holds no waves; give the summary.json of 'upbead waves'")
    return WavesSummary(summary)
