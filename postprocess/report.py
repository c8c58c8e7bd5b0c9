#!/usr/bin/python3
"""Makes one self-contained HTML page of a run, study, life, calibration or waves: for readers of the results who do
not use the program.

The page needs no network and no other file; it can be mailed. It prints on A4, and --pdf does that by Chromium.
"""

import argparse
from pathlib import Path

from common import keep_inputs
from report import kinds, pdf
from report.language import LANGUAGES
from upbead.errors import UserError


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "folder", type=Path, help="folder that run, study, expected, calibrate or waves wrote"
    )
    parser.add_argument(
        "-o", "--output", type=Path, metavar="FILE", help="the page (.html); default: report.html in the folder"
    )
    parser.add_argument("--language", choices=LANGUAGES, help="of the document; default: that of the case, else English")
    parser.add_argument("--pdf", type=Path, metavar="FILE", help="print the page to this file too; needs Chromium")
    parser.add_argument(
        "--case",
        type=Path,
        metavar="FILE",
        help="the case as written, for its remarks; default: looked for by its title",
    )
    arguments = parser.parse_args()
    output = arguments.output or arguments.folder / "report.html"
    for file in filter(None, (output, arguments.pdf)):
        keep_inputs(file, arguments.folder, *filter(None, (arguments.case,)))
    text = kinds.build(arguments.folder, arguments.case, arguments.language)
    try:
        output.write_text(text, encoding="utf-8")
    except OSError as error:
        raise UserError(f"cannot write '{output}': {error.strerror}") from error
    print(output)
    if arguments.pdf:
        pdf.write(output, arguments.pdf)
        print(arguments.pdf)


if __name__ == "__main__":
    main()
