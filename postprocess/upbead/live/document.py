"""One HTML file: the model's numbers, the modules that answer, and how they look."""

import html
import json
import re
from pathlib import Path

from ..errors import UserError
from ..kept import keep_inputs
from .model_data import model_data

HERE = Path(__file__).parent
# Each after those that it imports: in one script nothing needs to be imported.
MODULES = (
    "phi", "grid", "modes", "step", "slide", "fft", "trust", "base", "respond", "pulse", "record", "numbers", "plot",
    "element", "field", "controls", "told", "save", "whatif",
)  # fmt: skip
IMPORT = re.compile(r"^import .*;\n", re.MULTILINE)


def page(model, output=None):
    """Writes the page of a reduced model (reduced.h5 of `upbead reduce`, or its folder); returns its path.

    output: the page; default: page.html beside the model. It holds all that it shows, and needs no network.
    """
    model = Path(model)
    model = model / "reduced.h5" if model.is_dir() else model
    output = Path(output) if output else model.parent / "page.html"
    keep_inputs(output, model)
    text = document(model_data(model))
    try:
        output.write_text(text, encoding="utf-8")
    except OSError as error:
        raise UserError(f"cannot write '{output}': {error.strerror}") from error
    return output


def document(data):
    title, facts = html.escape(data["title"] or "Reduced model"), html.escape(facts_of(data)).replace("F_T", "<i>F</i><sub>T</sub>")
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1"><link rel="icon" href="data:,">'
        f"<title>{title}: what if</title><style>{read('page.css')}</style></head>\n"
        f'<body><main><h1>{title}</h1><p class="quiet">{facts}</p>\n{section(data)}</main></body></html>\n'
    )


def section(data):
    """What answers, for any page that has the colours of page.css."""
    return (
        f"<style>{read('whatif.css')}</style>\n"
        f'<section class="whatif" aria-label="What if"><noscript><p>This page answers by a script, and scripts are off.</p></noscript>'
        f'<script type="application/json" class="whatif-model">{as_json(data)}</script></section>\n'
        f'<script type="module">\n{script()}</script>\n'
    )


def script():
    """All modules as one."""
    return "".join(IMPORT.sub("", read(f"{name}.js")).replace("\nexport ", "\n") for name in MODULES)


def read(name):
    return (HERE / name).read_text(encoding="utf-8")


def as_json(data):
    """No text in it can end the script element."""
    return re.sub("[<>&\u2028\u2029]", lambda sign: f"\\u{ord(sign[0]):04x}", json.dumps(data, allow_nan=False, separators=(",", ":")))


def facts_of(data):
    validity = data["validity"]
    return (
        f"The scene as a sum of {data['modes']['count']} modes, exact for loads that are straight between times. F_T of the case's own loads within "
        f"{100 * validity['error']:.2g} %, checked up to {validity['highest_frequency']:.3g} Hz. Nothing is sent anywhere."
    )
