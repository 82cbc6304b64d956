"""Writes the pages of docs/: a folder a page, with what measures it, its numbers as JSON and its template."""

from pathlib import Path

ROOT = Path(__file__).parents[1]
"""The project."""
DOCS = ROOT / "docs"
FIGURES = DOCS / "figures"
PAGES = ROOT / "pages"
