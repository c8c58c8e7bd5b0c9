"""A page on paper, by Chromium without a window."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from ..errors import UserError

PROGRAMS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
SECONDS = 120


def browser():
    """Path of Chromium, or None."""
    return next(filter(None, map(shutil.which, PROGRAMS)), None)


def options(profile):
    """Options of every start without a window; Chromium's sandbox does not work for root."""
    rootless = [] if os.geteuid() else ["--no-sandbox"]
    return ["--headless=new", "--disable-gpu", "--no-first-run", f"--user-data-dir={profile}", *rootless]


def write(page, path):
    """Prints the HTML file `page` to `path`."""
    program = browser()
    if program is None:
        raise UserError("--pdf needs Chromium; install it (Debian: chromium), or print the page from a browser")
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / "page.pdf"
        command = [
            program,
            *options(f"{folder}/profile"),
            "--no-pdf-header-footer",
            f"--print-to-pdf={made}",
            page.resolve().as_uri(),
        ]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)
        except subprocess.TimeoutExpired as error:
            raise UserError(f"Chromium did not end within {SECONDS} s") from error
        if done.returncode != 0 or not made.is_file():
            raise UserError(f"Chromium made no PDF:\n{done.stderr[-2000:]}")
        try:
            shutil.copyfile(made, path)
        except OSError as error:
            raise UserError(f"cannot write '{path}': {error.strerror}") from error
