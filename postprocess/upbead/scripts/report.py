"""Makes one self-contained HTML page of a run, study, life, calibration or waves: for readers of the results who do
not use the program.

The page needs no network and no other file; it can be mailed. It prints on A4, and --pdf does that by Chromium.
"""

import argparse
from pathlib import Path

from ..kept import keep_inputs
from ..reporting import pdf
from ..reporting.language import LANGUAGES
from ..reports import report
from . import ending


def parse() -> argparse.Namespace:
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
    return parser.parse_args()


def main() -> None:
    ending.watch()
    arguments = parse()
    if arguments.pdf:
        keep_inputs(arguments.pdf, arguments.folder, *filter(None, (arguments.case,)))
    page = report(arguments.folder, arguments.output, language=arguments.language, case=arguments.case)
    print(page)  # before Chromium is asked, which may fail
    if arguments.pdf:
        pdf.write(page, arguments.pdf)
        print(arguments.pdf)
