"""Puts the program into the wheel: an installation by CMake, in upbead/installed.

Environment variables, as every version of pip hands them on:
  UPBEAD_PROGRAM   no: the package alone, for a program that is there already; a path: that build folder, as it is; default:
                   build-lean, else build, where there is one, brought up to date; else one is made in build (11 minutes)
  UPBEAD_BUNDLE    yes: the wheel has all libraries of the program, for machines without Debian's packages
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent
PROGRAM = os.environ.get("UPBEAD_PROGRAM", "")
sys.path.insert(0, str(HERE / "packaging"))  # a build in isolation does not see it


def build_folder():
    """The folder with the program."""
    if PROGRAM:
        return Path(PROGRAM).resolve()
    made = [folder for folder in (HERE / "build-lean", HERE / "build") if (folder / "upbead-solver").is_file()]
    folder = made[0] if made else HERE / "build"
    if not made:
        subprocess.run(["cmake", "--preset", "release", "-DUPBEAD_TESTS=OFF"], cwd=HERE, check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "help_pages"], cwd=HERE, check=True)
    return folder


class WithProgram(build_py):
    def run(self):
        shutil.rmtree(self.build_lib, ignore_errors=True)  # modules that are gone since
        super().run()
        if PROGRAM != "no" and not self.editable_mode:
            import wheel_files

            wheel_files.install(build_folder(), Path(self.build_lib) / "upbead/installed", os.environ.get("UPBEAD_BUNDLE") == "yes")


class Platform(Distribution):
    """A program is of one kind of machine."""

    def has_ext_modules(self):
        return PROGRAM != "no"


class AnyPython(bdist_wheel):
    """The program does not know Python, so the wheel is of every version of it."""

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


# not in build, which is CMake's
setup(distclass=Platform, cmdclass={"build_py": WithProgram, "bdist_wheel": AnyPython}, options={"build": {"build_base": "build-wheel"}})
