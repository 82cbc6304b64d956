"""Write the laws in C and in JavaScript: ``python -m translation``, or ``make laws``."""

from __future__ import annotations

import os
from pathlib import Path

os.environ["POINTPRED_COMPILED"] = "0"  # what is translated is read from the functions in Python

from translation import c_files, entries, modules, stages

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = {
    "pointpred": ROOT / "pointpred" / "laws",
    "pointpred_observers": ROOT / "observers" / "pointpred_observers" / "laws",
}
"""Where the C of each distribution lies."""
WEB = ROOT / "server" / "pointpred_server" / "web"

if __name__ == "__main__":
    for package, folder in FOLDERS.items():
        c_files.write(package, folder)
    modules.write(WEB / "lib" / "laws")
    entries.write(WEB / "lib" / "entries")
    (WEB / "page" / "service" / "descriptions.js").write_text(stages.descriptions_text(), "utf-8")
