#!/usr/bin/env python3
"""Draws a mesh: cells in the colour of their surface, and the named curves.

Takes a gmsh mesh (.msh, text, 2.2 or 4.1), or a gmsh script (.geo) where the program gmsh is installed.
"""

import argparse
import shutil
import subprocess
import tempfile
from pathlib import Path

from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

import msh
from common import UserError, plt, run, save

SURFACE_COLOURS = ["#f3e3b3", "#b9c6b0", "#c9ccd4", "#bfdcee", "#e6c9b8", "#d9cbe8"]


def mesh_of_script(script, settings):
    """Runs gmsh on a .geo with ["name=value", ...] and reads what it makes."""
    if shutil.which("gmsh") is None:
        raise UserError("a .geo needs the program gmsh; install it, or give a .msh")
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / "made.msh"
        command = ["gmsh", "-2", str(script), "-o", str(made), "-v", "2"]
        for setting in settings:
            name, equals, value = setting.partition("=")
            if not equals:
                raise UserError(f"--set {setting}: say NAME=VALUE")
            command += ["-setnumber", name.strip(), value.strip()]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0 or not made.is_file():
            raise UserError(f"gmsh cannot mesh '{script}':\n{done.stdout}{done.stderr}")
        return msh.read(made)


def draw(mesh, title):
    figure, axes = plt.subplots(figsize=(10, 4.5))
    handles = []
    for number, (name, cells) in enumerate(mesh.surfaces.items()):
        colour = SURFACE_COLOURS[number % len(SURFACE_COLOURS)]
        corners = [[mesh.points[node] for node in cell] for cell in cells]
        axes.add_collection(PolyCollection(corners, facecolor=colour, edgecolor="0.45", linewidth=0.3))
        handles.append(Patch(facecolor=colour, edgecolor="0.45", label=f"{name}: {len(cells)} cells"))
    for number, (name, edges) in enumerate(mesh.curves.items()):
        ends = [[mesh.points[node] for node in edge] for edge in edges]
        axes.add_collection(LineCollection(ends, color=f"C{number % 10}", linewidth=2.0))
        handles.append(Line2D([], [], color=f"C{number % 10}", linewidth=2.0, label=name))
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    axes.set_title(title)
    axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, 0.0), borderaxespad=4.5, ncol=6)
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh", type=Path, help="a .msh or a .geo")
    parser.add_argument("-o", "--output", type=Path, help="figure (.png, .pdf, .svg); default: beside the mesh, .png")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="a parameter of the .geo")
    parser.add_argument("--zoom", type=float, nargs=4, metavar=("X0", "X1", "Y0", "Y1"), help="draw a part only, m")
    arguments = parser.parse_args()
    if not arguments.mesh.is_file():
        raise UserError(f"there is no file '{arguments.mesh}'")
    if arguments.mesh.suffix == ".geo":
        mesh = mesh_of_script(arguments.mesh, arguments.set)
    elif arguments.set:
        raise UserError("--set is for a .geo; a .msh has no parameters")
    else:
        mesh = msh.read(arguments.mesh)
    figure = draw(mesh, arguments.mesh.name)
    if arguments.zoom:
        figure.axes[0].set_xlim(*arguments.zoom[:2])
        figure.axes[0].set_ylim(*arguments.zoom[2:])
    save(figure, arguments.output or arguments.mesh.with_suffix(".png"))


if __name__ == "__main__":
    run(main)
