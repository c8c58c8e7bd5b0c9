"""Shared by the scripts: how they end with an error, and how they write a figure."""

import sys
from pathlib import Path

from upbead.errors import UpbeadError, UserError
from upbead.kept import keep_inputs

__all__ = ["UserError", "beside", "figure_argument", "keep_inputs", "save"]


def tell(kind, error, trace):
    """Prints as a message what the caller can correct, be it found by an import; the exit code is 1."""
    script = Path(sys.argv[0]).name
    if issubclass(kind, UpbeadError):
        print(f"{script}: {error}", file=sys.stderr)
    elif issubclass(kind, OSError) and error.filename is not None:
        print(f"{script}: cannot read or write '{error.filename}': {error.strerror}", file=sys.stderr)
    elif issubclass(kind, UnicodeDecodeError):
        print(f"{script}: a file that should be text is none: {error}", file=sys.stderr)
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
