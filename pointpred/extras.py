"""Optional libraries and distributions: what brings them, and the command that installs it here."""

from __future__ import annotations

import json
import shlex
import sys
from importlib.metadata import PackageNotFoundError, distribution
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

from pointpred.errors import MissingExtraError

SYSTEM = {"linux": ("hidraw", "Xlib"), "darwin": ("Quartz",)}
"""What reads mice and the cursor on each system."""
EXTRAS = {
    "report": ("jinja2", "matplotlib", "pandas", "scipy", "statsmodels"),
    "tables": ("openpyxl", "pyxdf"),
    "live": (*SYSTEM.get(sys.platform, ()), "pylsl"),
    "client": ("websockets",),
    "train": ("scipy",),
    "observers": ("clarabel", "cvxpy", "scipy", "sympy"),
    "camera": ("cv2",),
    "cluster": ("dask", "distributed"),
    "remote": ("fsspec",),
}
"""What each extra brings, by the names that are imported."""


def absent(extra: str) -> list[str]:
    """The libraries of an extra that are not installed."""
    return [name for name in EXTRAS[extra] if find_spec(name) is None]


def require(extra: str, purpose: str, *more: str) -> None:
    """Raise MissingExtraError, with the command that installs what is missing, where a library is.

    ``more``: further extras that the purpose needs.
    """
    missing = {name: absent(name) for name in (extra, *more)}
    lacking = [name for name, libraries in missing.items() if libraries]
    if lacking:
        libraries = dict.fromkeys(library for name in lacking for library in missing[name])
        raise missing_extra(",".join(lacking), f"{purpose} needs {', '.join(libraries)}")


def missing_extra(extra: str, why: str) -> MissingExtraError:
    """The error for an extra that is not installed; ``why`` says what needs which library."""
    return MissingExtraError(f"{why}. Install it, which takes about a minute: {install_command(extra)}")


def missing_distribution(name: str, why: str) -> MissingExtraError:
    """The error for a distribution that is not installed; ``why`` says what is in it."""
    checkout = _checkout()
    folder = name.removeprefix("pointpred-")
    command = _pip("-e", str(Path(checkout, folder))) if checkout else _pip(name)
    return MissingExtraError(f"{why} is in {name}, which is not installed. Install it: {command}")


def install_command(extra: str) -> str:
    """The shell command that installs an extra for the Python that runs, from the checkout if it runs one."""
    checkout = _checkout()
    return _pip("-e", f"{checkout}[{extra}]") if checkout else _pip(f"pointpred[{extra}]")


def _pip(*what: str) -> str:
    return f"{shlex.quote(sys.executable or 'python')} -m pip install {shlex.join(what)}"


def _checkout() -> str | None:
    """The folder of the sources, where pointpred was installed from them with ``pip install -e``."""
    try:
        record = json.loads(distribution("pointpred").read_text("direct_url.json") or "{}")
    except (PackageNotFoundError, ValueError):
        return None
    if not record.get("dir_info", {}).get("editable"):
        return None
    return url2pathname(urlsplit(record["url"]).path)
