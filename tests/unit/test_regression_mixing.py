"""The mixing step against exact fractions and against numpy."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.regression import drem


def exact_determinant(rows: list[list[Fraction]]) -> Fraction:
    if not rows:
        return Fraction(1)
    minors = ([row[:j] + row[j + 1 :] for row in rows[1:]] for j in range(len(rows)))
    return sum(((-1) ** j * rows[0][j] * exact_determinant(m) for j, m in enumerate(minors)), Fraction(0))


def exact_adjugate_times(rows: list[list[Fraction]], y: list[Fraction]) -> list[Fraction]:
    """By cofactors: entry i of adj(A) y is the sum over k of cofactor(k, i) y_k."""
    n = len(rows)
    answer = []
    for i in range(n):
        total = Fraction(0)
        for k in range(n):
            minor = [row[:i] + row[i + 1 :] for r, row in enumerate(rows) if r != k]
            total += (-1) ** (k + i) * exact_determinant(minor) * y[k]
        answer.append(total)
    return answer


def mix(matrix: np.ndarray, y: np.ndarray) -> tuple[float, np.ndarray]:
    n = len(y)
    given, mixed = (matrix.copy(), y.copy()), np.zeros(n)
    phi = drem.mix(matrix, y, mixed, np.zeros(n * n))
    assert np.array_equal(matrix, given[0])
    assert np.array_equal(y, given[1])
    return phi, mixed


@pytest.mark.parametrize("n", [2, 3, 4, 5, 6])
def test_regular_matrices_agree_with_determinant_times_inverse(n: int) -> None:
    rng = np.random.default_rng(n)
    for _ in range(20):
        matrix, y = rng.standard_normal((n, n)), rng.standard_normal(n)
        phi, mixed = mix(matrix, y)
        assert phi == pytest.approx(np.linalg.det(matrix), rel=1e-9, abs=1e-12)
        wanted = np.linalg.det(matrix) * np.linalg.solve(matrix, y)
        np.testing.assert_allclose(mixed, wanted, rtol=1e-8, atol=1e-10)


@given(st.data())
def test_singular_integer_matrices_have_their_exact_adjugate(data: st.DataObject) -> None:
    n = data.draw(st.integers(2, 5))
    entry = st.integers(-6, 6)
    rows = [[data.draw(entry) for _ in range(n)] for _ in range(n)]
    first, second = data.draw(entry), data.draw(entry)
    rows[n - 1] = [first * a + second * b for a, b in zip(rows[0], rows[n - 2], strict=True)]  # rank < n
    y = [data.draw(entry) for _ in range(n)]
    phi, mixed = mix(np.array(rows, np.float64), np.array(y, np.float64))
    exact = exact_adjugate_times([[Fraction(v) for v in row] for row in rows], [Fraction(v) for v in y])
    size = float(np.prod([max(1.0, np.hypot.reduce(np.array(row, np.float64))) for row in rows]))
    assert abs(phi) <= 1e-13 * size
    assert mixed == pytest.approx([float(v) for v in exact], abs=1e-12 * size * 10)


def test_an_adjugate_that_is_not_zero_though_the_matrix_is_singular() -> None:
    phi, mixed = mix(np.array([[1.0, 2.0], [2.0, 4.0]]), np.array([1.0, 5.0]))
    assert phi == 0.0
    assert mixed.tolist() == [4.0 * 1.0 - 2.0 * 5.0, -2.0 * 1.0 + 1.0 * 5.0]


def test_the_closed_form_for_three_agrees_with_elimination() -> None:
    rng = np.random.default_rng(3)
    matrix = rng.standard_normal((3, 3))
    phi, _ = mix(matrix, np.ones(3))
    assert phi == pytest.approx(drem.determinant(matrix.copy()), rel=1e-12)
