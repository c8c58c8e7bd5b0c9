"""The report of results: one HTML page for readers who do not use the program."""

from __future__ import annotations

from os import PathLike
from pathlib import Path

from .errors import UserError
from .kept import keep_inputs


def report(folder: str | PathLike[str], output: str | PathLike[str] | None = None, *, language: str | None = None,
           pdf: str | PathLike[str] | None = None, case: str | PathLike[str] | None = None) -> Path:
    """Writes one self-contained HTML page of a run, study, life, calibration, sheet or waves.

    Parameters
    ----------
    folder : path
        The folder that the command of the program wrote.
    output : path, optional
        The page; default: report.html in the folder.
    language : {"en", "ja"}, optional
        Default: that of the case, else English.
    pdf : path, optional
        Prints the page to this file, too, by Chromium.
    case : path, optional
        The case as its author wrote it, for its remarks; default: looked for by its title.

    Returns
    -------
    Path
        The page.

    Raises
    ------
    UserError
        The folder has no results, or a file cannot be written.
    """
    from .reporting import kinds  # a report reads 50 modules that nothing else needs
    from .reporting import pdf as paper

    folder, output = Path(folder), Path(output) if output else Path(folder) / "report.html"
    files = [output] + ([Path(pdf)] if pdf else [])
    for file in files:
        keep_inputs(file, folder, *((case,) if case else ()))
    text = kinds.build(folder, Path(case) if case else None, language)
    try:
        output.write_text(text, encoding="utf-8")
    except OSError as error:
        raise UserError(f"cannot write '{output}': {error.strerror}") from error
    if pdf:
        paper.write(output, Path(pdf))
    return output
