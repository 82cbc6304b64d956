"""What drawing a report needs beyond what pointpred itself needs."""

from __future__ import annotations

from importlib.util import find_spec

from pointpred.errors import MissingExtraError

NEEDED = ("matplotlib", "pandas", "scipy", "statsmodels")


def check_installed() -> None:
    """Raise MissingExtraError, with the line that installs it, where something is missing."""
    missing = [name for name in NEEDED if find_spec(name) is None]
    if missing:
        raise MissingExtraError(f"a report needs {', '.join(missing)}: pip install 'pointpred[report]'")
