"""What is known of pointpred and how: a folder a question, with what measures, its numbers and its page."""

from pathlib import Path

ROOT = Path(__file__).parents[1]
"""The project."""
DOCS = ROOT / "docs"
FIGURES = DOCS / "figures"
EVIDENCE = ROOT / "evidence"
