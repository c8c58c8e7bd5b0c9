#!/usr/bin/python3
"""Writes what a Debian package contains besides the program: changelog, copyright, commands for the scripts, and the
Python package.

usage: debian_files.py SOURCE PAGES VERSION PREFIX
"""

import gzip
import pathlib
import shutil
import sys

COPYRIGHT = """Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: upbead

Files: *
Copyright: 2026 The upbead authors
License: BSD-3-Clause
"""
CHANGELOG = """upbead ({version}) unstable; urgency=medium

  * What is new: /usr/share/upbead/CHANGELOG.md.

 -- The upbead authors <upbead@localhost>  Wed, 25 Nov 2026 00:00:00 +0000
"""
COMMANDS = {"upbead-report": "report.py", "upbead-page": "page.py", "upbead-fit": "fit.py", "upbead-sensitivity": "sensitivity.py"}
WHAT = {"upbead-report": "one HTML page of a run", "upbead-page": "one HTML page that answers other waves",
        "upbead-fit": "fits soils to records", "upbead-sensitivity": "tells which soil decides, by Sobol's indices"}


def packed(text, file):
    """Compressed as by gzip -9n, without name and time: every build gives the same bytes."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(gzip.compress(text.encode(), 9, mtime=0))


def link(file, target):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.unlink(missing_ok=True)
    file.symlink_to(target)


def licence(text):
    """As a field of the copyright file: lines begin with a blank, empty ones are a dot."""
    return "".join(f" {line}\n" if line.strip() else " .\n" for line in text.splitlines())


def main():
    source, pages, prefix = (pathlib.Path(sys.argv[i]) for i in (1, 2, 4))
    doc = prefix / "share/doc/upbead"
    packed(CHANGELOG.format(version=sys.argv[3]), doc / "changelog.gz")
    (doc / "copyright").write_text(COPYRIGHT + licence((source / "LICENSE").read_text()))
    shutil.rmtree(prefix / "share/man", ignore_errors=True)
    for page in sorted((pages / "man1").glob("*.1")):
        packed(page.read_text(), prefix / "share/man/man1" / (page.name + ".gz"))
    for program in ("upbead-solver", "upbead-reliability"):
        link(prefix / "share/man/man1" / (program + ".1.gz"), "upbead.1.gz")
    for command, script in COMMANDS.items():
        link(prefix / "bin" / command, "../share/upbead/postprocess/" + script)
        packed(f'.TH {command.upper()} 1 "" "upbead" "User Commands"\n.SH NAME\n{command} \\- {WHAT[command]}\n'
               f".SH DESCRIPTION\n{command} \\-\\-help tells how.\n.SH SEE ALSO\nupbead(1)\n",
               prefix / "share/man/man1" / (command + ".1.gz"))
    link(prefix / "lib/python3/dist-packages/upbead", "../../../share/upbead/postprocess/upbead")


if __name__ == "__main__":
    main()
