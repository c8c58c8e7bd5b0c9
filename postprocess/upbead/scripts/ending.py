"""How scripts and commands end. It imports nothing of the package, as a module that is missing has to be told, too."""

import atexit
import errno
import os
import signal
import sys
from pathlib import Path

NAME = Path(sys.argv[0]).name
UNWRITTEN = (errno.EPIPE, errno.ENOSPC, errno.EDQUOT, errno.EFBIG)


def tell(kind, error, trace):
    """Prints as a message what the caller can correct, be it found by an import: an UpbeadError, a module that is not
    installed, a full disk, a file that cannot be read. The exit code is 1."""
    if issubclass(kind, ModuleNotFoundError):
        print(f"{NAME}: {sys.executable} has no module '{error.name}'; call the script with another Python that has it, such as "
              f"/usr/bin/python3, or install it: {sys.executable} -m pip install {error.name}", file=sys.stderr)
    elif any(base.__name__ == "UpbeadError" for base in kind.__mro__):
        print(f"{NAME}: {error}", file=sys.stderr)
    elif issubclass(kind, OSError) and error.filename is None and error.errno in UNWRITTEN:
        cannot_write(error)
    elif issubclass(kind, OSError) and error.filename is not None:
        print(f"{NAME}: cannot read or write '{error.filename}': {error.strerror}", file=sys.stderr)
    elif issubclass(kind, UnicodeDecodeError):
        print(f"{NAME}: a file that should be text is none: {error}", file=sys.stderr)
    else:
        sys.__excepthook__(kind, error, trace)


def cannot_write(error):
    """Ends the script where a disk is full; where the reader of its stdout went away, as in `| head`, without a word."""
    if error.errno == errno.EPIPE:
        os._exit(128 + signal.SIGPIPE)
    print(f"{NAME}: not all could be written: {error.strerror}; make room there, or send it elsewhere", file=sys.stderr, flush=True)
    os._exit(1)


def write_all():
    """Writes what was printed before the script ends: Python would end with 120 and two lines of its own."""
    try:
        if sys.stdout:  # not closed from the start
            sys.stdout.flush()
    except OSError as error:
        cannot_write(error)


def watch():
    """From here on mistakes are told as messages."""
    sys.excepthook = tell
    atexit.register(write_all)
