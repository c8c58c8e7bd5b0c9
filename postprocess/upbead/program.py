"""Finds and calls the program."""

import os
import shutil
import subprocess
from pathlib import Path

from .errors import CaseError, NumericsError, UpbeadError, UserError
from .places import WHEEL

ROOT = Path(__file__).resolve().parents[2]
INSIDE = WHEEL / "bin/upbead"  # of a wheel
BESIDE = ROOT / "build/upbead"  # in a source tree
INSTALLED = ROOT / "../../bin/upbead"  # from share/upbead of an installation, see docs/install.md


def find(program=None):
    """The program's path.

    The given path; else $UPBEAD; else that of the wheel; else build/upbead beside this package; else the program of the
    same installation; else `upbead` on the PATH.
    """
    places = [("argument 'program'", program)] if program else [
        ("environment variable UPBEAD", os.environ.get("UPBEAD")),
        ("inside the wheel", INSIDE),
        ("beside the package", BESIDE),
        ("of the same installation", INSTALLED),
        ("PATH", "upbead"),
    ]
    tried = []
    for name, place in places:
        found = shutil.which(str(place)) if place else None
        if found and not is_this_package(found):
            return str(Path(found).resolve())
        tried.append(f"{name}: {place or 'not set'}")
    raise UserError("the program 'upbead' was not found; tried\n  " + "\n  ".join(tried))


def is_this_package(found):
    """Whether a command is that of a wheel, which would call itself: scripts.command."""
    with open(found, "rb") as file:
        return file.read(2) == b"#!" and b"upbead.scripts.command" in file.read(2000)


def environment(program):
    """The variables for the program: that of a wheel finds its libraries beside it, and Open MPI its parts."""
    libraries = WHEEL / "lib"
    if Path(program).parent != INSIDE.parent or not libraries.is_dir():
        return dict(os.environ)
    found = os.pathsep.join(filter(None, (str(libraries), os.environ.get("LD_LIBRARY_PATH"))))
    parts = {"OPAL_PREFIX": str(libraries / "openmpi")} if (libraries / "openmpi").is_dir() else {}
    return {**os.environ, "LD_LIBRARY_PATH": found, **parts}


def toml_value(value):
    """A value as TOML, for --set.

    >>> toml_value("friction"), toml_value(True), toml_value(5e6), toml_value([[0, 1.0]]), toml_value({"ratio": 0.05})
    ('"friction"', 'true', '5000000.0', '[[0, 1.0]]', '{"ratio" = 0.05}')
    """
    if hasattr(value, "tolist"):  # numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)  # inf and nan are the same words in TOML
    if isinstance(value, (str, Path)):
        escaped = str(value).replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")
        return f'"{escaped}"'
    if isinstance(value, dict):
        return "{" + ", ".join(f"{toml_value(str(key))} = {toml_value(v)}" for key, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml_value, value)) + "]"
    raise UserError(f"{value!r} has no form in TOML; use numbers, words, True, False, lists and dicts")


def settings(values):
    """["--set", "key=value", ...]"""
    return [word for key, value in (values or {}).items() for word in ("--set", f"{key}={toml_value(value)}")]


def call(arguments, program=None):
    """Runs the program without showing its progress; raises CaseError or NumericsError with its own text."""
    command = find(program)
    done = subprocess.run([command, *map(str, arguments)], capture_output=True, text=True, check=False, env=environment(command))
    if done.returncode == 0:
        return done.stdout
    text = done.stderr.strip() or done.stdout.strip()
    if done.returncode == 1:
        raise CaseError(text)
    if done.returncode == 2:
        raise NumericsError(text)
    raise UpbeadError(f"upbead {arguments[0]} ended with exit code {done.returncode}\n{text}")
