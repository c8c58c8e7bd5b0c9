#!/usr/bin/python3
"""Which soil decides, by a model of soils; an installation has it as upbead-sensitivity."""

import common  # noqa: F401: its hook shows errors without a traceback
from upbead.scripts.sensitivity import main

if __name__ == "__main__":
    main()
