"""Shared by the scripts: how they end with an error, and how they write a figure."""

import sys
from pathlib import Path

from upbead.errors import UpbeadError, UserError
from upbead.kept import keep_inputs

__all__ = ["UserError", "beside", "figure_argument", "keep_inputs", "save"]


def tell(kind, error, trace):
    """Prints an UpbeadError as a message, be it of an import; the exit code is 1."""
    if issubclass(kind, UpbeadError):
        print(f"{Path(sys.argv[0]).name}: {error}", file=sys.stderr)
    else:
        sys.__excepthook__(kind, error, trace)


sys.excepthook = tell


def save(figure, path, *inputs):
    """Writes the figure in the format of the file's ending (.png, .pdf, .svg), never over one of `inputs`."""
    keep_inputs(path, *inputs)
    from upbead import figures  # only imported by scripts that make a figure

    figures.save(figure, path)
    print(path)


def figure_argument(parser, name):
    parser.add_argument("-o", "--output", type=Path, help=f"figure (.png, .pdf, .svg); default: {name}, by the results")


def beside(results, name):
    """The path of a file in the folder of results, or in the folder of a file of results; never in the working
    folder."""
    return (results if results.is_dir() else results.parent) / name
