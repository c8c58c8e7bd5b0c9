"""Where the program, the geometries and the pages are that belong to this package."""

import os
from pathlib import Path

HERE = Path(__file__).resolve().parent
WHEEL = HERE / "installed"  # of a wheel: what `cmake --install` makes, with the libraries of the program
BESIDE = HERE.parents[1]  # a source tree, or share/upbead of an installation: docs/install.md


def share() -> Path:
    """The folder with meshes, cases and docs."""
    inside = WHEEL / "share/upbead"
    return inside if inside.is_dir() else BESIDE


def meshes() -> Path:
    """The folder of the shipped geometries, as the program looks for it."""
    return Path(os.environ.get("UPBEAD_MESHES") or share() / "meshes")


def docs() -> Path:
    """The folder of the pages, from whose tables the meaning of a key is read."""
    return share() / "docs"
