"""Opens HDF5 files."""

import h5py


def open_h5(path, mode="r"):
    """An h5py.File without a lock: some network file systems have none, and h5py calls a sound file on them broken."""
    try:
        return h5py.File(path, mode, locking=False)
    except (TypeError, ValueError):  # h5py before 3.5 and HDF5 before 1.10.7 always lock
        return h5py.File(path, mode)
