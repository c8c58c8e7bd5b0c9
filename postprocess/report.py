#!/usr/bin/python3
"""Makes one self-contained HTML page of results; an installation has it as upbead-report."""

import common  # noqa: F401: its hook shows errors without a traceback
from upbead.scripts.report import main

if __name__ == "__main__":
    main()
