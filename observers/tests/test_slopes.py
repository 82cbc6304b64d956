"""Slopes that a caller states are compared with those of f: a proof that rests on wrong ones is none."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from pointpred.errors import ParameterError
from pointpred_observers import Persidskii
from pointpred_observers.files import decoded, encoded
from pointpred_observers.plants.nonlinearity import KNOWN, true_slopes, value


def plant(f: Any, slopes: Any, domain: float = np.inf) -> Persidskii:
    return Persidskii(
        [[0.0, 1.0], [-1.0, -1.0]], [0.0, -1.0], [1.0, 0.0], f, C0=[1.0, 0.0], slopes=slopes, domain=domain
    )


NARROW = [
    ("cube", [[0.0, 0.5]], 1.0, "between 0 and 3"),
    ("tanh", (0.5, 0.6), 0.5, "between 0.786448 and 1"),
    ("tanh", (0.9, 1.0), np.inf, "everywhere: its slopes there lie between 0 and 1"),
    ("saturation", (0.0, 0.5), np.inf, "between 0 and 1"),
    ("cube", (0.0, 3.0), np.inf, "between 0 and inf"),
]


@pytest.mark.parametrize(("f", "slopes", "domain", "words"), NARROW)
def test_slopes_narrower_than_those_of_a_name_are_refused(
    f: str, slopes: Any, domain: float, words: str
) -> None:
    with pytest.raises(ParameterError, match=words) as wrong:
        plant(f, slopes, domain)
    assert wrong.value.field == "slopes"


@pytest.mark.parametrize("name", KNOWN)
@pytest.mark.parametrize("domain", [0.5, 1.0, 2.0, 4.0])
def test_the_true_slopes_of_a_name_are_those_of_its_differences(name: str, domain: float) -> None:
    low, high = true_slopes(KNOWN[name].code, domain)
    s = np.linspace(-domain, domain, 4001)
    steps = np.diff([value(KNOWN[name].code, float(one)) for one in s]) / np.diff(s)
    assert low == pytest.approx(steps.min(), abs=3e-3 * max(1.0, high))
    assert high == pytest.approx(steps.max(), abs=3e-3 * max(1.0, high))
    assert plant(name, (low, high), domain).slopes == ((low, high),)
    assert plant(name, (low - 1.0, high + 1.0), domain).domain == domain


WRONG = [
    (np.tanh, (0.0, 0.5), np.inf, "slopes of f must hold everywhere"),
    (np.tanh, (0.9, 1.0), 1.0, "within 1: between -1"),
    (lambda s: s**3, (0.0, 3.0), 2.0, "rises by"),
    (lambda s: 1.0 / s, (-1.0, 1.0), 1.0, "at arguments of 0 it returns"),
    (lambda s: 1j * s, (0.0, 1.0), 1.0, "complex"),
    (lambda s: np.zeros(3), None, 1.0, r"the shape \(3,\), need \(1,\)"),
]


@pytest.mark.parametrize(("f", "slopes", "domain", "words"), WRONG, ids=[row[3] for row in WRONG])
def test_a_function_that_violates_its_slopes_is_refused(
    f: Any, slopes: Any, domain: float, words: str
) -> None:
    with pytest.raises(ParameterError, match=words):
        plant(f, slopes, domain)


def test_functions_with_their_true_slopes_are_taken() -> None:
    for f, slopes, domain in [
        (np.tanh, (0.0, 1.0), np.inf),
        (lambda s: s * np.abs(s), (0.0, 8.0), 4.0),
        (lambda s: 1e6 + 1e-3 * np.sin(s), (-1e-3, 1e-3), np.inf),
        (np.sin, (np.cos(1e-3), 1.0), 1e-3),
        (lambda s: 1.0 / s, None, np.inf),  # nothing is said of its slopes
    ]:
        assert plant(f, slopes, domain).domain == domain
    both = Persidskii(-np.eye(2), np.eye(2), np.eye(2), np.arctan, slopes=[(0.0, 1.0), (-1.0, 1.0)])
    assert both.at(0.0).f.checked == np.inf


def test_a_wider_domain_is_checked_again() -> None:
    inside = plant(np.sin, (0.5, 1.0), 1.0)
    with pytest.raises(ParameterError, match="within 2"):
        plant(inside.f, None, 2.0)


def test_another_function_of_a_file_must_fit_its_slopes() -> None:
    text = encoded(plant(np.tanh, (0.0, 1.0)))
    assert decoded(text, functions={"f": np.arctan}).slopes == ((0.0, 1.0),)
    with pytest.raises(ParameterError, match="component 0 rises by"):
        decoded(text, functions={"f": np.sin})
    narrow = encoded(plant("tanh", (-0.5, 1.0))).replace(b"-0.5", b"0.5")
    with pytest.raises(ParameterError, match="'tanh', must hold everywhere"):
        decoded(narrow)


def rotation(s: Any) -> Any:
    return np.array([np.tanh(s[0] + 1e-6 * s[1]), np.tanh(s[1])])


MIXED = [
    (lambda s: s[::-1], (1.0, 1.0), np.inf, "component 1 may depend upon argument 1 only"),
    (lambda s: s[::-1], (1.0, 1.0), 1e-9, "as argument 0 moves from"),
    (rotation, (0.0, 1.1), np.inf, "component 0 may depend upon argument 0 only"),
    (lambda s: s * np.array([1.0, np.cos(s[0] * s[1] - s[1] ** 2)]), (-9.0, 9.0), 1.0, "component 1 may"),
]


@pytest.mark.parametrize(("f", "slopes", "domain", "words"), MIXED)
def test_slopes_of_a_function_that_mixes_its_arguments_are_refused(
    f: Any, slopes: Any, domain: float, words: str
) -> None:
    """Corner proofs take f for diagonal; with f = (s2, s1) x' = -x + A1 f(x) was proved, and x grows."""
    with pytest.raises(ParameterError, match=words) as wrong:
        Persidskii(-np.eye(2), [[0.0, 5.0], [-5.0, 0.0]], np.eye(2), f, slopes=slopes, domain=domain)
    assert wrong.value.field == "f"
    assert Persidskii(-np.eye(2), np.eye(2), np.eye(2), f).slopes is None


def test_a_function_with_slopes_is_called_within_its_domain_only_and_seldom() -> None:
    seen: list[Any] = []

    def f(s: Any) -> Any:
        seen.append(s.copy())
        s[:] = np.arcsin(s)  # in place: what f does to its argument is its own affair
        return s

    Persidskii(-np.eye(3), np.eye(3), np.eye(3), f, slopes=(1.0, 2e4), domain=0.999)
    assert np.abs(seen).max() <= 0.999
    assert len(seen) < 200


def test_slopes_need_as_many_arguments_as_components() -> None:
    with pytest.raises(ParameterError, match=r"3 components .* and 2 arguments"):
        Persidskii(-np.eye(2), np.ones((2, 3)), np.eye(2), lambda s: np.full(3, s.sum()), slopes=(0.0, 1.0))
