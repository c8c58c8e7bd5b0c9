"""The report of a run: one self-contained HTML page. `page.build` makes it; the command is upbead-report, the function `upbead.report`."""
