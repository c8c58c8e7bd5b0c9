#!/usr/bin/python3
"""Fits keys of a case to records and modes; an installation has it as upbead-fit."""

import common  # noqa: F401: its hook shows errors without a traceback
from upbead.scripts.fit import main

if __name__ == "__main__":
    main()
