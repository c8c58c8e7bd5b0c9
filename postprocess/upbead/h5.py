"""Opens HDF5 files."""

from __future__ import annotations

from os import PathLike

import h5py


def open_h5(path: str | PathLike[str], mode: str = "r") -> h5py.File:
    """An h5py.File without a lock: some network file systems have none, and h5py calls a sound file on them broken."""
    try:
        return h5py.File(path, mode, locking=False)
    except (TypeError, ValueError):  # h5py before 3.5 and HDF5 before 1.10.7 always lock
        return h5py.File(path, mode)
