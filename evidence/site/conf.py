"""The site of all pages, by Sphinx: ``make site``. Its pages are the project's own Markdown files."""

from __future__ import annotations

import shutil
from pathlib import Path

from sphinx.application import Sphinx

from evidence.site import contents

ROOT = Path(__file__).parents[2]

project = html_title = "pointpred"
author = "the authors of pointpred"
copyright = "the authors of pointpred; Apache-2.0"
extensions = ["myst_parser"]
root_doc = contents.FIRST.removesuffix(".md")
include_patterns = contents.paths()
exclude_patterns = [".*", "build", "demo", "dist", "node_modules", "site"]
myst_heading_anchors = 6
highlight_language = "none"
suppress_warnings = ["misc.highlighting_failure"]  # of languages that Pygments does not know

html_theme = "furo"
html_favicon = str(ROOT / "server/pointpred_server/web/page/icon.svg")
html_copy_source = True
html_use_index = False
html_show_sourcelink = False
html_sourcelink_suffix = ""
html_static_path = ["page.js"]
html_js_files = ["page.js"]

MOVING = ("docs/figures/live.webp", "docs/figures/live.png")
"""Pictures that the README shows by HTML, which Sphinx does not copy."""
SOURCES = "_sources"
"""Where Sphinx copies the Markdown to."""
LIVE = """
<a href="demo/index.html">Move your mouse over the live page.</a> A browser loads it only from a server; for a
folder on this machine that is `python -m http.server --directory site`, then <http://localhost:8000/>.
"""


def add_to_the_front_page(app: Sphinx, document: str, text: list[str]) -> None:
    """The navigation, which docs/README.md lists, and the live page, which is a part of the site only."""
    if document != root_doc:
        return
    entries = "```{{toctree}}\n:hidden:\n:caption: {title}\n\n{pages}\n```\n"
    named = {title: [page.path for page in pages] for title, pages in contents.sections().items()}
    named = {"Contents": ["docs/README.md"], **named}
    text[0] = text[0].replace("</picture>\n", f"</picture>\n{LIVE}", 1) + "\n".join(
        entries.format(title=title, pages="\n".join(f"/{page.removesuffix('.md')}" for page in pages))
        for title, pages in named.items()
    )


def add_files(app: Sphinx, failed: Exception | None) -> None:
    """The front page under the name that hosts look for, its pictures, and two files for language models."""
    if failed is not None:
        return
    out = Path(app.outdir)
    shutil.copy(out / f"{root_doc}.html", out / "index.html")
    for name in MOVING:
        (out / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, out / name)
    (out / "llms.txt").write_text(contents.short_list(f"{SOURCES}/"), encoding="utf-8")
    contents.copy_pictures(out / SOURCES)
    (out / "llms-full.txt").write_text(contents.full_text(), encoding="utf-8")


def setup(app: Sphinx) -> None:
    """Called by Sphinx."""
    app.connect("source-read", add_to_the_front_page)
    app.connect("build-finished", add_files)
