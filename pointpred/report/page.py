"""The page around a report: ``report.html`` holds its style and the protocol in words."""

from __future__ import annotations

import platform
from collections.abc import Sequence
from importlib.metadata import PackageNotFoundError, version
from importlib.resources import files
from string import Template

from pointpred.report.tables import table, text

PACKAGES = ("pointpred", "numpy", "numba", "scipy", "statsmodels", "matplotlib")


def versions_table() -> str:
    """What computed the report."""
    rows = [("Python", text(platform.python_version()))]
    for name in PACKAGES:
        try:
            rows.append((name, text(version(name))))
        except PackageNotFoundError:  # run from a source tree that is not installed
            rows.append((name, "not installed as a package"))
    return table("Versions", ("package", "version"), rows, words=True)


def page(title: str, contents: Sequence[tuple[str, str]], body: str) -> str:
    """One HTML document without a single request.

    ``contents``: name and conclusion of each set, where there are several; set i has the anchor ``set-i`` in
    ``body``.
    """
    entries = "".join(
        f'<li><a href="#set-{i}">{text(name)}</a>: {text(words, 1000)}</li>'
        for i, (name, words) in enumerate(contents)
    )
    template = files("pointpred.report").joinpath("report.html").read_text(encoding="utf-8")
    return Template(template).substitute(
        title=text(title),
        contents=f'<nav aria-label="Sets"><ul>{entries}</ul></nav>' if entries else "",
        body=body,
        versions=versions_table(),
    )
