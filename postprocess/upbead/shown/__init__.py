"""Display of results in a notebook: HTML that needs no server, no network and no installation."""

from .mixin import Shown

__all__ = ["Shown"]
