"""The pages as a site: sphinx-build -W --keep-going -c docs . build-site

Pages stay where they are and read on the forge as they are. docs/README.md is the home page, and what it links to below
each of its headings is the navigation; a README.md elsewhere brings in the pages that it links to in its own folder.

Rows of the reference's tables are objects of the search: every key of a file and of a summary by its whole path, every warning, every
symbol of the glossary.
"""

import re
from pathlib import Path, PurePosixPath

from docutils import nodes
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

OBJECTS = {  # page: what a row of its tables is called in the search
    "docs/reference/case": "key of a case", "docs/reference/design": "key of a design", "docs/reference/study": "key of a study",
    "docs/reference/warnings": "warning", "docs/glossary": "symbol",
    **{f"docs/reference/summary-{command}": f"number of {command}"
       for command in ("run", "explain", "sheet", "respond", "waves", "expected", "calibrate", "reliability", "indices")},
}
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


def type_of(page):
    """The Sphinx name of the objects of a page."""
    return OBJECTS[page].replace(" ", "-")


def names_in(row, section, page):
    """Names that a row of a table is found by: the path of a key, a warning, each symbol of "N, N', M'"."""
    first = row.children[0]
    if page == "docs/glossary":
        return [name for name in first.astext().replace("\u2019", "'").split(", ") if name]
    literals = list(first.findall(nodes.literal))
    where = section[1:-1] if section.startswith("[") else section
    at_top = page.endswith("warnings") or where == "top of the file" or where.startswith("summary.json")
    return ["" if at_top and not literals else ".".join(filter(None, ["" if at_top else where, text.astext()])) for text in literals[:1]]


def add_objects(app, doctree):
    page = app.env.docname
    if page not in OBJECTS:
        return
    known = set()
    for body in doctree.findall(nodes.tbody):
        section = body.parent.parent.parent
        title = section.next_node(nodes.title).astext() if isinstance(section, nodes.section) else ""
        for row in body.findall(nodes.row):
            for name in names_in(row, title, page):
                if name and name not in known:
                    known.add(name)
                    label = f"found-{len(known)}"
                    row["ids"].append(label)
                    app.env.get_domain("std").note_object(type_of(page), name, label)


def setup(app):
    app.connect("source-read", add_navigation)
    app.connect("doctree-read", add_objects)
    for page, name in OBJECTS.items():
        app.add_object_type(type_of(page), type_of(page), objname=name)
