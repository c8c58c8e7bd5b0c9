"""Dicts of results that say what is near when a name is wrong."""

from __future__ import annotations

from typing import Any

from .errors import UnknownName
from .near import hint


class Named(dict[str, Any]):
    """A dict; a wrong key is told with what is like it.

    >>> Named(response=1)["respons"]
    Traceback (most recent call last):
    upbead.errors.UnknownName: there is no 'respons'; did you mean response?
    """

    def __missing__(self, key: str) -> Any:
        raise UnknownName(f"there is no '{key}'{hint(str(key), [str(one) for one in self])}")


def named(value: Any) -> Any:
    """The same with a Named in place of every dict."""
    if isinstance(value, dict):
        return Named((key, named(inside)) for key, inside in value.items())
    return [named(inside) for inside in value] if isinstance(value, list) else value
