#!/usr/bin/python3
"""The pages build as a site without a warning (a broken link, a page that docs/README.md does not lead to), and the site needs no
network. Where Sphinx or its parts are not installed, exit 77: skipped.

    site_pages.py FOLDER_OF_THE_PROJECT
"""

import importlib.util
import pathlib
import re
import subprocess
import sys
import tempfile

FROM_NETWORK = re.compile(r"""<(?:script|link|img|iframe)\b[^>]*\b(?:src|href)=["'](?:https?:)?//[^"']*["'][^>]*>|url\(["']?(?:https?:)?//[^)]*\)""")


def build(root, folder):
    command = [sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-d", f"{folder}/kept", "-c", f"{root}/docs", str(root), f"{folder}/site"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    return [] if done.returncode == 0 else [done.stdout + done.stderr]


def from_network(site):
    for path in [*site.rglob("*.html"), *site.rglob("*.css")]:
        for match in FROM_NETWORK.findall(path.read_text(encoding="utf-8", errors="replace")):
            yield f"{path.relative_to(site)} needs the network: {match}"


def main():
    missing = [name for name in ("sphinx", "myst_parser", "sphinx_rtd_theme") if importlib.util.find_spec(name) is None]
    if missing:
        print(f"site: not built, as {', '.join(missing)} is not installed (packages.txt)")
        return 77
    root = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        wrong = build(root, folder) or list(from_network(pathlib.Path(folder, "site")))
        pages = len(list(pathlib.Path(folder, "site").rglob("*.html")))
    print("\n".join(wrong) or f"site: {pages} pages, every link leads somewhere, nothing from the network")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
