"""Write the laws in JavaScript for the page: ``python -m translation``, or ``make page``."""

from __future__ import annotations

from pathlib import Path

from translation.modules import write

if __name__ == "__main__":
    write(Path(__file__).resolve().parent.parent / "server" / "pointpred_server" / "web" / "laws")
