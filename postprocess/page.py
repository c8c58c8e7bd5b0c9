#!/usr/bin/env python3
"""Makes one self-contained HTML page of a reduced model, which answers any wave while one drags.

The page needs no network and no other file; it can be mailed.
"""

import argparse
from pathlib import Path

from common import run
from upbead import page


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", type=Path, help="the model, made by 'upbead reduce' (.h5), or the folder with its reduced.h5")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="the page (.html); default: page.html beside the model")
    arguments = parser.parse_args()
    print(page(arguments.model, arguments.output))


if __name__ == "__main__":
    run(main)
