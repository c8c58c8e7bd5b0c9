"""Meshes of gmsh scripts (.geo), made by the program gmsh if it is installed."""

import shutil
import subprocess
import tempfile
from pathlib import Path

from . import msh
from .errors import UserError


def mesh_of_script(script, parameters):
    """The Mesh of a script with {name: value} instead of its own values."""
    if shutil.which("gmsh") is None:
        raise UserError(f"'{Path(script).name}' needs the program gmsh; install it, or give a .msh")
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / "made.msh"
        command = ["gmsh", "-2", str(script), "-o", str(made), "-v", "2"]
        for name, value in parameters.items():
            command += ["-setnumber", name, str(value)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0 or not made.is_file():
            raise UserError(f"gmsh cannot mesh '{script}':\n{done.stdout}{done.stderr}")
        return msh.read(made)
