"""Compiles the laws as the library's ``setup.py`` does; a source distribution holds that file instead."""

from pathlib import Path
from runpy import run_path

run_path(str(Path(__file__).resolve().parents[1] / "setup.py"))
