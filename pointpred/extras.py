"""Optional libraries and distributions: what brings them, and the command that installs it here."""

from __future__ import annotations

import sys
from importlib import import_module
from importlib.metadata import PackageNotFoundError, distribution
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from warnings import warn

from pointpred.errors import MissingExtraError

SYSTEM = {"linux": ("hidraw", "Xlib"), "darwin": ("Quartz",)}
"""What reads mice and the cursor on each system."""
OWN = "pointpred"
EXTRAS = {
    "report": ("jinja2", "matplotlib", "pandas", "scipy", "statsmodels"),
    "tables": ("openpyxl", "pyxdf"),
    "live": (*SYSTEM.get(sys.platform, ()), "pylsl"),
    "client": ("websockets",),
    "train": ("scipy",),
    "cluster": ("dask", "distributed"),
    "remote": ("fsspec",),
}
"""What each extra brings, by the names that are imported."""


def absent(extra: str) -> list[str]:
    """The libraries of an extra that are not installed."""
    return [name for name in EXTRAS[extra] if find_spec(name) is None]


def require(extra: str, purpose: str) -> None:
    """Raise MissingExtraError, with the command that installs what is missing, where a library is."""
    if missing := absent(extra):
        raise missing_extra(extra, f"{purpose} needs {', '.join(missing)}")


def missing_extra(extra: str, why: str, *, of: str = OWN) -> MissingExtraError:
    """The error for what is not installed: an extra, or ``""`` for the distribution ``of`` itself.

    ``why`` says what needs which library.
    """
    command = install_command(extra, of=of)
    return MissingExtraError(f"{why}. Install it, which takes about a minute: {command}")


def missing_distribution(name: str, why: str) -> MissingExtraError:
    """The error for a distribution that is not installed; ``why`` says what is in it."""
    return missing_extra("", f"{why} is in {name}, which is not installed", of=name)


def moved_to_observers(old: str, new: str, name: str) -> Any:
    """What ``name`` of a module is that is now ``new``, in the distribution pointpred-observers."""
    if find_spec("pointpred_observers") is None:
        raise missing_extra("", f"{old} has moved", of="pointpred-observers")
    warn(f"{old} is {new} now", DeprecationWarning, stacklevel=3)
    return getattr(import_module(new), name)


def install_command(extra: str = "", *, of: str = OWN) -> str:
    """The shell command that installs an extra for the Python that runs, from the checkout if it runs one.

    ``of``: the distribution; in a checkout ``pointpred-observers`` lies in the folder ``observers``.
    """
    import shlex

    checkout, brackets = _checkout(), extra and f"[{extra}]"
    if checkout and of != OWN:
        checkout = str(Path(checkout, of.removeprefix(f"{OWN}-")))
    what = ["-e", f"{checkout}{brackets}"] if checkout else [f"{of}{brackets}"]
    return f"{shlex.quote(sys.executable or 'python')} -m pip install {shlex.join(what)}"


def _checkout() -> str | None:
    """The folder of the sources, where pointpred was installed from them with ``pip install -e``."""
    # Here, because every start of the command loads this module.
    import json
    from urllib.parse import urlsplit
    from urllib.request import url2pathname

    try:
        record = json.loads(distribution(OWN).read_text("direct_url.json") or "{}")
    except (PackageNotFoundError, ValueError):
        return None
    if not record.get("dir_info", {}).get("editable"):
        return None
    return url2pathname(urlsplit(record["url"]).path)
