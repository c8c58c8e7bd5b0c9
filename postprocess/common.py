"""What the figures share: how they end with an error, and how they look."""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)

plt.rcParams.update(
    {
        "font.size": 9,
        "axes.grid": True,
        "grid.alpha": 0.3,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "legend.frameon": False,
        "savefig.dpi": 150,
    }
)


class UserError(Exception):
    """Something that the person who runs a script can mend."""


def run(main):
    """Runs a script's main function; a UserError ends it with a message and exit code 1."""
    try:
        main()
    except UserError as error:
        print(f"{Path(sys.argv[0]).name}: {error}", file=sys.stderr)
        sys.exit(1)


def save(figure, path):
    """Writes the figure in the format of the file's ending (.png, .pdf, .svg)."""
    known = figure.canvas.get_supported_filetypes()
    if path.suffix.lstrip(".").lower() not in known:
        raise UserError(f"'{path}': unknown format '{path.suffix}'; use .png, .pdf or .svg")
    try:
        figure.savefig(path, bbox_inches="tight")
    except OSError as error:
        raise UserError(f"cannot write '{path}': {error.strerror}") from error
    print(path)
