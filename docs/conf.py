"""The pages as a site: sphinx-build -W --keep-going -c docs . build-site

Pages stay where they are and read on the forge as they are. docs/README.md is the home page, and what it links to below
each of its headings is the navigation; a README.md elsewhere brings in the pages that it links to in its own folder.
"""

import re
from pathlib import Path, PurePosixPath

import sphinx_rtd_theme  # noqa: F401  of Debian, with its fonts and scripts: the site needs no network

project = "upbead"
copyright = "the upbead authors"
extensions = ["myst_parser", "sphinx_rtd_theme"]
source_suffix = {".md": "markdown"}
root_doc = "docs/README"
exclude_patterns = [".*", "build*", "results", "src", "include", "tests", "postprocess", "**/node_modules"]
myst_heading_anchors = 4  # the forge's anchors; a link to one that is not there is an error
suppress_warnings = ["myst.header", "misc.highlighting_failure"]
html_theme = "sphinx_rtd_theme"
html_theme_options = {"navigation_depth": 2}
html_show_sphinx = False
html_copy_source = False

PAGE = re.compile(r"\]\(([^)#\s:]+\.md)")


def pages(text, folder):
    """Names of the pages that a text links to, once each."""
    names = (re.sub(r"[^/]+/\.\./", "", str(folder / link).removesuffix(".md")) for link in PAGE.findall(text))
    return list(dict.fromkeys(names))


def navigation(caption, names):
    lines = ["", "```{toctree}", ":hidden:", *([f":caption: {caption}"] if caption else []), "", *(f"/{name}" for name in names), "```"]
    return "\n".join(lines) + "\n"


def add_navigation(app, name, source):
    folder, text = PurePosixPath(name).parent, source[0]
    if name == root_doc:
        seen = {name}
        for part in re.split(r"^## ", text, flags=re.MULTILINE)[1:]:
            fresh = [page for page in pages(part, folder) if page not in seen]
            seen.update(fresh)
            source[0] += navigation(part.partition("\n")[0], fresh)
    elif folder.name and PurePosixPath(name).name == "README":
        below = [page for page in pages(text, folder) if page.startswith(f"{folder}/") and Path(app.srcdir, f"{page}.md").exists()]
        if below:
            source[0] += navigation("", below)


def setup(app):
    app.connect("source-read", add_navigation)
