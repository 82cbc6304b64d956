"""Every package that is installed has a licence that goes with ours, and is listed with it."""

from __future__ import annotations

import re

import pytest

from evidence.data import stored
from evidence.reference.licences import licence_of, packages

COMPATIBLE = {
    *(
        "0BSD",
        "Apache-2.0",
        "BSD",
        "BSD-2-Clause",
        "BSD-3-Clause",
        "CC0-1.0",
        "ISC",
        "MIT",
        "MIT-0",
        "MIT-CMU",
    ),
    *("PSF-2.0", "Zlib", "Apache-2.0 WITH LLVM-exception", "Unlicense"),
}
REASONS = {
    "certifi": "MPL-2.0",
    "hidapi": "BSD OR GPL-3.0",
    "hypothesis": "MPL-2.0",
    "pathspec": "MPL-2.0",
    "python-xlib": "LGPL-2.1-or-later",
}
"""Packages whose other licence is accepted, for the reason that the page gives."""
LISTED = {str(row[0]): str(row[1]) for row in stored("reference", "licences").tables["licences"].rows}


def compatible(licence: str) -> bool:
    """Whether every part of an expression, or one of its alternatives, is compatible."""
    return any(
        all(part in COMPATIBLE for part in alternative.split(" AND "))
        for alternative in re.sub("[()]", "", licence).split(" OR ")
    )


def test_the_list_holds_every_package_and_no_other() -> None:
    assert sorted(LISTED) == sorted(packages()), "run `python -m evidence reference licences`, `make docs`"


@pytest.mark.parametrize("name", packages())
def test_a_package_has_a_compatible_licence(name: str) -> None:
    licence = LISTED[name]
    assert compatible(licence) or REASONS.get(name) == licence, f"{name} is under {licence!r}"
    installed = licence_of(name)
    assert installed in (None, licence), "run `python -m evidence reference licences`, then `make docs`"
