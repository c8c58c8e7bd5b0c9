"""Reads what `upbead waves` has written."""

import json

from common import UserError


def read(path):
    """The summary of a folder or of a summary.json, with its waves."""
    file = path / "summary.json" if path.is_dir() else path
    try:
        summary = json.loads(file.read_text())
    except OSError as error:
        raise UserError(f"cannot read '{file}': {error.strerror}") from error
    except ValueError as error:
        raise UserError(f"'{file}' is no JSON: {error}") from error
    if not isinstance(summary, dict) or not summary.get("waves") or "section" not in summary:
        raise UserError(f"'{file}' holds no waves; give the summary.json of 'upbead waves'")
    return summary
