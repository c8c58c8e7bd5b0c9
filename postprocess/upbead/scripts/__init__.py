"""What the commands upbead, upbead-report, upbead-page, upbead-fit and upbead-sensitivity call; postprocess/report.py, page.py, fit.py and
sensitivity.py are the same."""
