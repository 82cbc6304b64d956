"""Which licence each package has that pointpred installs: ``python -m evidence reference licences``.

Takes the packages of ``constraints.txt`` as they are installed here, by ``make .venv/.ready .venv/.site``,
and what their metadata say.
"""

from __future__ import annotations

from importlib.metadata import Distribution, PackageNotFoundError, distribution

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from evidence import ROOT
from evidence.arguments import parse
from evidence.data import Table, keep

COLUMNS = ("package", "licence", "needed for")
OWN = ("pointpred", "pointpred-server", "pointpred-observers")
"""The project's distributions."""
SITE = ROOT / "evidence" / "site" / "requirements.txt"
CLASSIFIED = {
    "Apache Software License": "Apache-2.0",
    "BSD License": "BSD",
    "GNU General Public License v3 (GPLv3)": "GPL-3.0",
    "GNU Lesser General Public License v2 or later (LGPLv2+)": "LGPL-2.1-or-later",
    "ISC License (ISCL)": "ISC",
    "MIT License": "MIT",
    "Mozilla Public License 2.0 (MPL 2.0)": "MPL-2.0",
    "Python Software Foundation License": "PSF-2.0",
}
"""What the classifiers of packages call the licences."""
NAMED = {"Apache 2.0": "Apache-2.0", "BSD-3-Clause": "BSD", "MIT License": "MIT"}
"""What the free text of packages calls them."""
FILES = {"kosoku": "MIT"}
"""Packages whose metadata name only the file of the licence, read by a person."""


def packages() -> list[str]:
    """The names in ``constraints.txt``."""
    lines = (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()
    return [line.partition("==")[0] for line in lines if "==" in line and not line.startswith("#")]


def licence_of(name: str) -> str | None:
    """The licence of an installed package; ``None`` where it is not installed, "" where it says nothing."""
    try:
        about = distribution(name).metadata
    except PackageNotFoundError:
        return None
    if expression := about.get("License-Expression"):
        return str(expression)
    classifiers = [one.split(" :: ")[-1] for one in about.get_all("Classifier") or []]
    if known := [CLASSIFIED[one] for one in classifiers if one in CLASSIFIED]:
        return " OR ".join(known)
    text = (about.get("License") or FILES.get(canonicalize_name(name), "")).strip().partition("\n")[0]
    return NAMED.get(text, text)


def needed_by(*start: tuple[str, tuple[str, ...]]) -> set[str]:
    """The packages that these distributions with these extras install, the project's excepted."""
    found: set[str] = set()
    waiting = [*start]
    while waiting:
        name, wanted = waiting.pop()
        try:
            requirements = distribution(name).requires or []
        except PackageNotFoundError:
            continue
        for requirement in map(Requirement, requirements):
            marker = requirement.marker
            there = marker is None or any(marker.evaluate({"extra": extra}) for extra in ("", *wanted))
            key = canonicalize_name(requirement.name)
            if there and (key not in found or key in OWN):
                if key not in OWN:
                    found.add(key)
                waiting.append((requirement.name, tuple(requirement.extras)))
    return found


def purpose(name: str, needed: dict[str, set[str]]) -> str:
    """The first that a package is needed for."""
    key = canonicalize_name(name)
    return next((what for what, names in needed.items() if key in names), "tests")


def provided(own: Distribution) -> tuple[str, ...]:
    """The extras for users."""
    names = own.metadata.get_all("Provides-Extra") or []
    return tuple(name for name in names if name != "dev")


def main() -> None:
    tools = SITE.read_text(encoding="utf-8").splitlines()[1:]
    needed = {
        "running": needed_by((OWN[0], ()), (OWN[1], ())),
        "extras": needed_by(*((name, provided(distribution(name))) for name in OWN)),
        "tests": needed_by((OWN[0], ("dev",))),
        "site": {*tools, *needed_by(*((name, ()) for name in tools))},
    }
    rows = [(name, licence_of(name) or "unknown", purpose(name, needed)) for name in packages()]
    keep("reference", {"licences": Table.of(COLUMNS, rows)}, part="licences")


if __name__ == "__main__":
    parse(__doc__)
    main()
