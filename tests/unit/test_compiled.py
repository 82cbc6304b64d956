"""The cache of compiled laws notices what numba does not: a change in what a law reaches."""

from __future__ import annotations

from types import FunctionType

import pytest

from pointpred import compiled

pytestmark = pytest.mark.skipif(not compiled.COMPILED, reason="POINTPRED_COMPILED=0: nothing is compiled")


def law_reading(constant: float, callee: object) -> str:
    """The fingerprint of one and the same source in a module with these globals."""

    def source(x: float) -> float:
        return CALLEE(x) + CONSTANT  # type: ignore[name-defined, no-any-return]  # noqa: F821

    scope = {"CONSTANT": constant, "CALLEE": callee, "__name__": "module"}
    return compiled._fingerprint(FunctionType(source.__code__, scope))


@compiled.law
def doubled(x: float) -> float:
    return 2.0 * x


@compiled.law
def tripled(x: float) -> float:
    return 3.0 * x


@compiled.layout
def quadrupled(x: float) -> float:
    return 4.0 * x


def test_the_same_law_has_the_same_fingerprint() -> None:
    assert law_reading(1.0, doubled) == law_reading(1.0, doubled)


def test_another_constant_or_another_callee_is_another_law() -> None:
    fingerprints = {law_reading(1.0, doubled), law_reading(2.0, doubled), law_reading(1.0, tripled)}
    fingerprints.add(law_reading(1.0, quadrupled))
    assert len(fingerprints) == 4


def test_a_layout_stays_plain_python_and_laws_may_call_it() -> None:
    @compiled.law
    def through(x: float) -> float:
        return quadrupled(x)

    assert isinstance(quadrupled, FunctionType)
    assert through(2.0) == 8.0
