"""A wheel has the whole package and the program, and works in a venv that sees nothing of Debian's but what the package
says that it needs.

usage: test_wheel.py FOLDER_OF_THE_PROJECT FOLDER_OF_THE_BUILD [at_length]
"""

import configparser
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest
import zipfile
from pathlib import Path

PROJECT, BUILD = (Path(argument).resolve() for argument in sys.argv[1:3])
PYTHON, DEBIAN = "/usr/bin/python3", Path("/usr/lib/python3/dist-packages")
# numpy, h5py and matplotlib, and what these need in turn
NEEDED = ("numpy", "h5py", "matplotlib", "mpl_toolkits", "packaging", "PIL", "kiwisolver", "contourpy", "cycler", "cycler.py", "dateutil", "pyparsing",
          "pyparsing.py", "six.py", "fontTools", "pylab.py")
LEFT = ("UPBEAD", "UPBEAD_MESHES", "PYTHONPATH", "UPBEAD_BUNDLE")


def call(*command, **variables):
    environment = {key: value for key, value in os.environ.items() if key not in LEFT} | variables
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False, env=environment)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def source_in(folder):
    """What a wheel is made of, in a folder of its own."""
    source = folder / "source"
    shutil.copytree(PROJECT / "postprocess/upbead", source / "postprocess/upbead", ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", "setup.py"):
        shutil.copy(PROJECT / name, source)
    for name in ("packaging", "docs", "LICENSE"):
        (source / name).symlink_to(PROJECT / name)
    return source


def made(source, **variables):
    target = Path(tempfile.mkdtemp(dir=source.parent))
    call("/usr/bin/pip3", "wheel", source, "--no-build-isolation", "--no-deps", "--no-index", "-w", target, **variables)
    return next(target.glob("*.whl"))


def declared(path):
    return tomllib.loads(path.read_text(encoding="utf-8"))


LONG = sys.argv[3:] == ["at_length"]
SYSTEM = ("libc.so.6", "libm.so.6", "libdl.so.2", "librt.so.1", "libpthread.so.0", "libresolv.so.2", "libutil.so.1", "libstdc++.so.6", "libgcc_s.so.1")


@unittest.skipIf(LONG or shutil.which("pip3", path="/usr/bin") is None, "at length, or no pip of Debian")
class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.source = source_in(cls.folder)
        cls.wheel = made(cls.source, UPBEAD_PROGRAM=str(BUILD))
        cls.venv = cls.folder / "venv"
        call(PYTHON, "-m", "venv", "--without-pip", cls.venv)
        site = next(cls.venv.glob("lib/python3*/site-packages"))
        for name in NEEDED:
            if (DEBIAN / name).exists():
                (site / name).symlink_to(DEBIAN / name)
        call("/usr/bin/pip3", "--python", cls.venv / "bin/python", "install", "--no-index", "--no-deps", cls.wheel)

    def python(self, code):
        return call(self.venv / "bin/python", "-B", "-I", "-c", code)

    def test_it_has_every_file_of_the_package(self):
        names = set(zipfile.ZipFile(self.wheel).namelist())
        package = PROJECT / "postprocess/upbead"
        kept = {str(path.relative_to(package.parent)) for path in package.rglob("*") if path.is_file() and "__pycache__" not in path.parts}
        self.assertEqual(kept - names, set())
        self.assertRegex(self.wheel.name, r"^upbead-[\d.]+-py3-none-linux_\w+\.whl$")

    def test_without_the_program_it_is_for_every_machine(self):
        wheel = made(self.source, UPBEAD_PROGRAM="no")
        self.assertTrue(wheel.name.endswith("-py3-none-any.whl"), wheel.name)
        self.assertFalse([name for name in zipfile.ZipFile(wheel).namelist() if "/installed/" in name])
        self.assertLess(wheel.stat().st_size, 1e6)

    def test_nothing_of_debian_is_seen_but_what_is_named(self):
        self.assertEqual(self.python("import importlib.util as u; print([n for n in ('scipy', 'pandas', 'h5py') if u.find_spec(n)])").strip(), "['h5py']")

    def test_commands(self):
        commands = self.venv / "bin"
        entries = configparser.ConfigParser()
        file = zipfile.ZipFile(self.wheel)
        entries.read_string(file.read(next(name for name in file.namelist() if name.endswith("entry_points.txt"))).decode())
        self.assertEqual(set(entries["console_scripts"]), {"upbead", "upbead-report", "upbead-page", "upbead-fit", "upbead-sensitivity"})
        for name in entries["console_scripts"]:
            self.assertIn("usage", call(commands / name, "--help").lower(), name)
        self.assertEqual(call(commands / "upbead", "--version"), call(BUILD / "upbead", "--version"))

    @unittest.skipIf(importlib.util.find_spec("ensurepip") is None, "no python3-venv")
    def test_it_is_installed_as_the_pages_say(self):
        """By the very line, on Debian as it is: outside of a venv pip refuses, and a plain venv sees no wheel and no h5py."""
        lines = {path: re.search(r"/usr/bin/python3 -m venv.* --no-deps", (PROJECT / path).read_text(encoding="utf-8")).group(0)
                 for path in ("README.md", "docs/python.md", "pyproject.toml")}
        self.assertEqual(len(set(lines.values())), 1, lines)
        source = source_in(Path(tempfile.mkdtemp(dir=self.folder)))
        call("sh", "-c", f"cd {source} && {lines['docs/python.md']} --no-index", UPBEAD_PROGRAM=str(BUILD))
        self.assertEqual(call(source / "venv/bin/upbead", "--version"), call(BUILD / "upbead", "--version"))
        self.assertIn("usage", call(source / "venv/bin/upbead-sensitivity", "--help"))

    def test_from_a_case_to_a_report(self):
        out, commands = self.folder / "out", self.venv / "bin"
        inside = self.python("from upbead import places; print(places.share())").strip()
        self.assertTrue(Path(inside).is_relative_to(self.venv), inside)
        call(commands / "upbead", "run", f"{inside}/cases/fig2b-model.toml", "--set", "mesh.parameters.cells=0.4", "--out", out)
        summary = json.loads((out / "summary.json").read_text())
        ratio = summary["response"]["shear_to_force_ratio"]
        told = self.python(f"import upbead; print(upbead.open({str(out)!r}).summary['response']['shear_to_force_ratio'], upbead.report({str(out)!r}))")
        self.assertEqual(told.split(), [str(ratio), f"{out}/report.html"])
        page = (out / "report.html").read_text(encoding="utf-8")
        self.assertIn("share of the pores in the volume", page)  # from docs/reference/case.md of the wheel
        call(commands / "upbead-report", out)
        self.assertEqual((out / "report.html").read_text(encoding="utf-8"), page)

    def test_every_module_can_be_imported_by_itself(self):
        """But those that draw need matplotlib, those that fit SciPy, which is an extra."""
        package = PROJECT / "postprocess/upbead"
        names = [".".join(path.relative_to(package.parent).with_suffix("").parts).removesuffix(".__init__") for path in package.rglob("*.py")]
        code = ("import importlib, sys\nfor name in sys.argv[1:]:\n    try:\n        importlib.import_module(name)\n"
                "    except ModuleNotFoundError as error:\n        print(name, error.name)\n")
        done = call(self.venv / "bin/python", "-B", "-I", "-c", code, *names)
        self.assertEqual({line.split()[1].partition(".")[0] for line in done.splitlines()} - {"scipy"}, set(), done)


@unittest.skipUnless(LONG and os.geteuid() == 0, "at length, as root: of its libraries 600 MB are copied, and tried below a root of their own")
class Bundled(unittest.TestCase):
    def test_it_runs_where_there_is_only_a_c_library(self):
        """Below a root with the C and the C++ library; what the variables are is asked of the package, in its place there."""
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder) / "root"
            for name in ("proc", "dev", "lib64", "lib/x86_64-linux-gnu"):
                (root / name).mkdir(parents=True)
            shutil.copy("/lib64/ld-linux-x86-64.so.2", root / "lib64")
            for name in SYSTEM:
                shutil.copy(Path("/lib/x86_64-linux-gnu") / name, root / "lib/x86_64-linux-gnu")
            wheel = made(source_in(Path(folder)), UPBEAD_PROGRAM=str(BUILD), UPBEAD_BUNDLE="yes")
            call(PYTHON, "-m", "zipfile", "-e", wheel, root)
            for program in (root / "upbead/installed/bin").iterdir():
                program.chmod(0o755)
            code = f"import sys; sys.path.insert(0, {str(root)!r}); from upbead import program as p; print(*map('='.join, p.environment(p.find()).items()), sep='\\n')"
            told = dict(line.split("=", 1) for line in call(PYTHON, "-B", "-c", code, LD_LIBRARY_PATH="").splitlines() if "=" in line)
            variables = {key: told[key].replace(str(root), "") for key in ("LD_LIBRARY_PATH", "OPAL_PREFIX", "PMIX_INSTALL_PREFIX")}
            inside = ("mount -t proc proc proc && mount --bind /dev dev && exec chroot . /upbead/installed/bin/upbead run "
                      "/upbead/installed/share/upbead/cases/fig2b-model.toml --set mesh.parameters.cells=0.4 --out /out")
            call("unshare", "-m", "sh", "-c", f"cd {root} && export {' '.join(f'{key}={value}' for key, value in variables.items())} && {inside}")
            summary = json.loads((root / "out/summary.json").read_text())
        self.assertAlmostEqual(summary["response"]["shear_to_force_ratio"], 0.75, delta=0.01)


@unittest.skipIf(LONG, "at length")
class Declared(unittest.TestCase):
    def test_both_ways_of_installing_say_the_same(self):
        whole, alone = (declared(PROJECT / path) for path in ("pyproject.toml", "postprocess/pyproject.toml"))
        for key in ("version", "dependencies", "optional-dependencies", "requires-python"):
            self.assertEqual(whole["project"][key], alone["project"][key], key)
        commands = dict(whole["project"]["scripts"])
        self.assertEqual(commands.pop("upbead"), "upbead.scripts.command:main")  # of the program, which the package alone lacks
        self.assertEqual(commands, alone["project"]["scripts"])
        sys.path.insert(0, str(PROJECT / "packaging"))
        import debian_files
        self.assertEqual({name: script.removesuffix(".py") for name, script in debian_files.COMMANDS.items()},
                         {name: module.split(".")[2].removesuffix(":main") for name, module in commands.items()})
        self.assertEqual(set(debian_files.WHAT), set(commands))
        for key in ("packages", "package-data"):
            self.assertEqual(whole["tool"]["setuptools"][key], alone["tool"]["setuptools"][key], key)
        program = re.search(r"project\(upbead VERSION ([\d.]+)", (PROJECT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)
        self.assertEqual(whole["project"]["version"], program)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
