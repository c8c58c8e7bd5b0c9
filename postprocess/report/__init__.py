"""The old name of `upbead.reporting`: `from report import units` is the same module as `from upbead.reporting import units`."""

import importlib
import importlib.abc
import importlib.util
import sys

NEW = "upbead.reporting"


class Renamed(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Finds report.NAME as upbead.reporting.NAME, so that no module is there twice."""

    def find_spec(self, fullname, path=None, target=None):
        inside = fullname.removeprefix(__name__ + ".")
        if inside == fullname or importlib.util.find_spec(f"{NEW}.{inside}") is None:
            return None
        return importlib.util.spec_from_loader(fullname, self)

    def create_module(self, spec):
        module = importlib.import_module(NEW + spec.name.removeprefix(__name__))
        self.own = module.__spec__
        return module

    def exec_module(self, module):
        module.__spec__ = self.own  # which the machinery of imports has replaced


if not any(type(finder).__name__ == "Renamed" for finder in sys.meta_path):
    sys.meta_path.insert(0, Renamed())
