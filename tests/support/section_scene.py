"""The case section.toml as a text, and changes of it."""

import pathlib

SCENE = (pathlib.Path(__file__).parent / "section.toml").read_text()
WIDTH = 18.0  # of the caisson (m)


def scene(*changes):
    """The case with changes (old, new), each only at its first place; an old text that does not occur is an error."""
    text = SCENE
    for old, new in changes:
        if old not in text:
            raise ValueError(f"section.toml has no '{old}'")
        text = text.replace(old, new, 1)
    return text
