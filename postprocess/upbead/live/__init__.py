"""An interactive page: a reduced model in one HTML file, with the code that evaluates it. docs/page.md explains its
use."""

from .document import page, section

__all__ = ["page", "section"]
