"""How results show themselves in a notebook: HTML that needs no server, no network and nothing to install."""

from .mixin import Shown

__all__ = ["Shown"]
