"""The coefficients in the page: a module, small once it is compressed, with the very numbers of the file."""

from __future__ import annotations

import gzip

import numpy as np
import pytest

from pointpred.predictors.kinematic import coefficient_file
from tests.intent.conftest import LIB
from tests.page import node
from translation.coefficients import coefficients_text

OWN = coefficient_file.read(coefficient_file.OWN)


@node.needed
def test_the_page_has_the_numbers_of_the_file() -> None:
    assert node.run("coefficients.mjs", None) == OWN.tolist()


def test_they_are_small_once_compressed() -> None:
    assert len(gzip.compress((LIB / "laws" / "kinematic.js").read_bytes(), 9)) < 16_000


@pytest.mark.parametrize("odd", [0.0, 1.0 + 2.0**-10, 2.0**-40])
def test_numbers_that_the_text_cannot_tell_are_refused(odd: float) -> None:
    with pytest.raises(ValueError, match="numbers of 9 bits"):
        coefficients_text(np.append(OWN, odd))
