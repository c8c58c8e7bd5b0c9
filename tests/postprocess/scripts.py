"""Calls the scripts of postprocess/ as a shell does, but in a fork of the test, which has read the libraries: reading
matplotlib takes a script a second."""

import os
import runpy
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py  # noqa: F401  for the forks
import matplotlib.pyplot  # noqa: F401  for the forks


def call(script, *arguments):
    """What the script printed, and its exit code."""
    command = [str(script), *map(str, arguments)]
    sys.stdout.flush()
    sys.stderr.flush()
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as errors:
        child = os.fork()
        if child == 0:
            os._exit(ended(command, out, errors))
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        texts = []
        for file in (out, errors):
            file.seek(0)
            texts.append(file.read().decode())
    return subprocess.CompletedProcess(command, code, *texts)


def ended(command, out, errors):
    """Runs the script in this process; returns its exit code."""
    os.dup2(out.fileno(), 1)
    os.dup2(errors.fileno(), 2)
    sys.stdout, sys.stderr = open(1, "w", closefd=False), open(2, "w", closefd=False)
    sys.argv, sys.dont_write_bytecode = command, True
    sys.path.insert(0, str(Path(command[0]).parent))
    code = 0
    try:
        runpy.run_path(command[0], run_name="__main__")
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else int(end.code is not None)
        if isinstance(end.code, str):
            print(end.code, file=sys.stderr)
    except BaseException:  # the script's own hook tells it, as in a shell
        sys.excepthook(*sys.exc_info())
        code = 1
    sys.stdout.flush()
    sys.stderr.flush()
    return code
