"""What the commands upbead, upbead-report, upbead-page and upbead-fit call; postprocess/report.py, page.py and fit.py are the same."""
