"""Makes one self-contained HTML page of a reduced model or of a design, which computes the response to any wave while
the user moves its sliders.

The page needs no network and no other file; it can be mailed.
"""

import argparse
from pathlib import Path

from ..live import page
from . import ending


def main() -> None:
    ending.watch()
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", type=Path, metavar="MODEL", help="a reduced model, made by 'upbead reduce' (.h5), or the folder with its reduced.h5; "
                        "or a design (.toml), or the folder that 'upbead waves' wrote of it")
    parser.add_argument("--design", type=Path, metavar="DESIGN", help="a design beside the model, whose waves the model answers")
    parser.add_argument("--beside", type=Path, nargs="+", default=[], metavar="MODEL", help="further models of the same loads, as of another soil, among which the page chooses")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="the page (.html); default: page.html beside the model, or in the folder of the results")
    arguments = parser.parse_args()
    print(page(arguments.model, arguments.output, arguments.design, beside=arguments.beside))
