#!/usr/bin/python3
"""The pages build as a site without a warning (a broken link, a page that docs/README.md does not lead to), the site needs no
network, and its search has every key, warning and symbol as an object. Where Sphinx or its parts are not installed, exit 77: skipped.

    site_pages.py FOLDER_OF_THE_PROJECT
"""

import html
import importlib.util
import json
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


SOUGHT = {"regions.NAME.interface.kind": "key of a case", "life.simulated_lives": "key of a design", "would_lift": "warning", "record_dead": "warning",
          "F_T": "symbol", "N'": "symbol", "sliding.coupled.glued_error": "number of run", "waves[].least_sliding_factor": "number of respond"}


def not_found(site):
    """What the search box does not have as an object: {"prefix": [[page, type, priority, anchor, name], ...]} of Sphinx's index."""
    index = json.loads((site / "searchindex.js").read_text(encoding="utf-8").removeprefix("Search.setIndex(").removesuffix(")"))
    found = {(html.unescape(f"{prefix}.{row[4]}" if prefix else row[4]), index["objnames"][str(row[1])][2]) for prefix, rows in index["objects"].items() for row in rows}
    for name, kind in SOUGHT.items():
        if (name, kind) not in found:
            yield f"the search does not find the {kind} {name}"
    if len(found) < 1000:
        yield f"the search has {len(found)} objects only"


def main():
    missing = [name for name in ("sphinx", "myst_parser", "sphinx_rtd_theme") if importlib.util.find_spec(name) is None]
    if missing:
        print(f"site: not built, as {', '.join(missing)} is not installed (packages.txt)")
        return 77
    root = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        wrong = build(root, folder) or [*from_network(pathlib.Path(folder, "site")), *not_found(pathlib.Path(folder, "site"))]
        pages = len(list(pathlib.Path(folder, "site").rglob("*.html")))
    print("\n".join(wrong) or f"site: {pages} pages, every link leads somewhere, nothing from the network")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
