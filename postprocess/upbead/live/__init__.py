"""A page that answers: a reduced model in one HTML file, with all that evaluates it. docs/page.md tells its use."""

from .document import page, section

__all__ = ["page", "section"]
