#!/usr/bin/python3
"""Makes one self-contained HTML page of a reduced model or of a design; an installation has it as upbead-page."""

import common  # noqa: F401: its hook shows errors without a traceback
from upbead.scripts.page import main

if __name__ == "__main__":
    main()
