#!/usr/bin/python3
"""Makes the simplest model from a reduced model: the caisson's mass on one spring and dashpot, F_T = c x' + k x.

usage: lumped_model.py REDUCED.h5 [--load LOAD] [-o LUMPED.h5]

Frequency and damping are those of the mode that carries most of F_T under that load. The file is a reduced model like
those of `upbead reduce`, for `respond`, `expected` and `calibrate`; it shows the effect of the other modes.
"""

import argparse
from pathlib import Path

from common import UserError, keep_inputs
from upbead.lumped_model import Source, write_lumped


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", metavar="REDUCED.h5", type=Path)
    parser.add_argument("--load", help="load that is the wave (default: that with the largest peak)")
    parser.add_argument("-o", "--output", type=Path, default=Path("lumped.h5"))
    arguments = parser.parse_args()
    keep_inputs(arguments.output, arguments.model)
    source = Source(arguments.model, arguments.load)
    try:
        frequency, damping = write_lumped(arguments.output, source)
    except OSError as error:
        raise UserError(f"cannot write '{arguments.output}': {error}") from error
    print(f"{arguments.output}: {frequency:.4g} Hz, {100 * damping:.3g} % of critical damping")


if __name__ == "__main__":
    main()
