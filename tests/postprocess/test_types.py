"""The package as a reader of its code meets it: types and docstrings of all that is public, imports without a circle, names
of Python's own that keep their meaning.

usage: test_types.py FOLDER_OF_THE_PROJECT [FOLDER_FOR_THE_CACHE_OF_MYPY]
"""

import ast
import builtins
import inspect
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

PROJECT = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2]).resolve()
CACHE = sys.argv[2] if len(sys.argv) > 2 else "/dev/null"
SCRIPTS = PROJECT / "postprocess"
sys.path.insert(0, str(SCRIPTS))

import upbead  # noqa: E402
from upbead import figures  # noqa: E402

FILES = sorted((SCRIPTS / "upbead").rglob("*.py"))
# names that are a contract: upbead.open, and `set` of run, study and the others, as --set of the program
CONTRACT = {"set", "open"}


def public():
    """(name, function) of everything that `import upbead` offers, with the methods of its classes."""
    for module, names in ((upbead, upbead.__all__), (figures, figures.__all__)):
        for name in names:
            thing = getattr(module, name)
            if inspect.isclass(thing):
                yield from ((f"{name}.{key}", method) for key, method in methods(thing))
            elif callable(thing):
                yield f"{module.__name__}.{name}", thing


def methods(kind):
    own = [base for base in kind.__mro__ if base.__module__.startswith("upbead")]
    for base in own:
        for key, member in vars(base).items():
            function = member.fget if isinstance(member, property) else getattr(member, "func", getattr(member, "__func__", member))
            made = "__dataclass_fields__" in vars(base) and key in ("__init__", "__repr__", "__eq__")  # by dataclass, of its fields
            if inspect.isfunction(function) and function.__module__.startswith("upbead") and not made:
                yield key, function


def module_of(path):
    parts = path.relative_to(SCRIPTS).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imported(path, known):
    """Modules of the package that a file imports when it is read."""
    name = module_of(path)
    above = name.split(".") if path.name == "__init__.py" else name.split(".")[:-1]
    for node in ast.parse(path.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.ImportFrom) and node.level:
            base = ".".join([*above[: len(above) - node.level + 1], *(node.module or "").split(".")]).strip(".")
            found = {f"{base}.{alias.name}" for alias in node.names} | {base}
            yield from (one for one in found if one in known and one != "upbead")


class Types(unittest.TestCase):
    def test_every_public_function_has_types(self):
        seen = 0
        for name, function in public():
            seen += 1
            signature = inspect.signature(function)
            missing = [key for key, given in list(signature.parameters.items()) if given.annotation is given.empty and key not in ("self", "cls")]
            self.assertEqual(missing, [], name)
            self.assertIsNot(signature.return_annotation, signature.empty, name)
        self.assertGreater(seen, 120)

    def test_every_public_thing_tells_what_it_is(self):
        for module, names in ((upbead, upbead.__all__), (figures, figures.__all__)):
            for name in names:
                self.assertTrue(inspect.getdoc(getattr(module, name)), name)

    def test_what_calls_the_program_says_its_parameters(self):
        for function in (upbead.run, upbead.study, upbead.report, upbead.page, upbead.fit, upbead.read_cfd, upbead.soil_posterior,
                         upbead.ReducedModel.respond, upbead.ReducedModel.transfer, upbead.SoilModel.respond):
            text = inspect.getdoc(function)
            for head in ("Parameters\n----------", "Returns\n-------"):
                self.assertIn(head, text, function.__qualname__)
            for key in list(inspect.signature(function).parameters):
                if key not in ("self", "keys"):
                    self.assertRegex(text, rf"(?m)^[\w, ]*\b{key}\b", f"{function.__qualname__}: {key}")

    @unittest.skipIf(shutil.which("mypy") is None, "no mypy")
    def test_mypy_is_content(self):
        done = subprocess.run(["mypy", "--cache-dir", CACHE, "--config-file", PROJECT / "pyproject.toml"], cwd=PROJECT, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


class Code(unittest.TestCase):
    def test_imports_have_no_circle(self):
        known = {module_of(path): path for path in FILES}
        graph = {name: set(imported(path, known)) - {name} for name, path in known.items() if name != "upbead"}
        while graph:  # take away what needs nothing that is left; a circle remains
            free = [name for name, needed in graph.items() if not needed & set(graph)]
            self.assertTrue(free, f"these import each other in a circle, or need one that does: {sorted(graph)}")
            for name in free:
                del graph[name]

    def test_no_name_of_python_is_shadowed(self):
        names = set(dir(builtins)) - CONTRACT
        for path in FILES:
            for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
                given = []
                if isinstance(node, ast.arg):
                    given = [node.arg]
                elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                    given = [node.id]
                elif isinstance(node, (ast.Import, ast.ImportFrom)):
                    given = [alias.asname or alias.name for alias in node.names]
                self.assertFalse(names & set(given), f"{path}:{getattr(node, 'lineno', 0)}")
            for node in ast.parse(path.read_text(encoding="utf-8")).body:  # methods may be called as in str or dict
                if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
                    self.assertNotIn(node.name, names, path)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
