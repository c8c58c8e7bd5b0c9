"""The author's picture as a data: address; its type is determined by its content, not by its name."""

import base64
import io
from xml.etree import ElementTree

from ..errors import UserError

MOST = 300_000  # bytes
SIGNATURES = {b"\x89PNG\r\n\x1a\n": "image/png", b"\xff\xd8\xff": "image/jpeg"}
SVG = "{http://www.w3.org/2000/svg}svg"


def address(path, place):
    """The address of a file; `place` names it in messages."""
    if path.exists() and not path.is_file():
        # reading a pipe could wait for ever
        raise UserError(f"{place}: '{path}' is no file; give a PNG, a JPEG or an SVG")
    try:
        size = path.stat().st_size
        if size > MOST:
            raise UserError(f"{place}: '{path}' has {size / 1e3:.0f} kB, more than {MOST // 1000}; save it with fewer pixels")
        content = path.read_bytes()
    except OSError as error:
        raise UserError(f"{place}: cannot read '{path}': {error.strerror}; its path is relative to the case file") from error
    kind = kind_of(content)
    if kind is None:
        raise UserError(f"{place}: '{path}' is neither PNG nor JPEG nor SVG; save it as one of them")
    return f"data:{kind};base64,{base64.b64encode(content).decode()}"


def kind_of(content):
    """The media type, or None. An SVG within <img> runs no script and fetches nothing."""
    for signature, kind in SIGNATURES.items():
        if content.startswith(signature):
            return kind
    try:
        _, root = next(ElementTree.iterparse(io.BytesIO(content), events=("start",)))
    except (ElementTree.ParseError, StopIteration, ValueError, LookupError):
        return None
    return "image/svg+xml" if root.tag == SVG else None
