"""The file of coefficients in the page: only such a file is taken."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.page import node

pytestmark = node.needed
FILE = Path(__file__).parents[2] / "server" / "pointpred_server" / "web" / "lib" / "laws" / "kinematic.f32"


def test_the_file_of_the_package_is_taken() -> None:
    packed = FILE.read_bytes()
    assert node.run("unpack.mjs", list(packed)) == len(packed) // 4


@pytest.mark.parametrize("length", [352, 3210, 3212])
def test_a_page_in_its_place_is_refused(length: int) -> None:
    """Some hosts answer with their index page where a file is missing."""
    page = (b"<!doctype html><title>index</title>" * 100)[:length]
    assert f"not a file of coefficients: {length} bytes" in node.run("unpack.mjs", list(page))
