#!/usr/bin/python3
"""Draws a mesh: cells in the colour of their surface, and the named curves.

Takes a gmsh mesh (.msh, text, 2.2 or 4.1), or a gmsh script (.geo) where the program gmsh is installed.
"""

import argparse
from pathlib import Path

from common import UserError, save
from upbead import figures, geo, msh


def settings(texts):
    """{name: value} of ["NAME=VALUE", ...]."""
    found = {}
    for text in texts:
        name, equals, value = text.partition("=")
        if not equals:
            raise UserError(f"--set {text}: say NAME=VALUE")
        found[name.strip()] = value.strip()
    return found


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
        mesh = geo.mesh_of_script(arguments.mesh, settings(arguments.set))
    elif arguments.set:
        raise UserError("--set is for a .geo; a .msh has no parameters")
    else:
        mesh = msh.read(arguments.mesh)
    figure = figures.mesh(mesh, arguments.mesh.name, arguments.zoom)
    save(figure, arguments.output or arguments.mesh.with_suffix(".png"), arguments.mesh)


if __name__ == "__main__":
    main()
