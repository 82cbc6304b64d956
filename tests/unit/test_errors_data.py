"""Errors are data: a program reads their code, field and value, never the sentence."""

from __future__ import annotations

import inspect
import pickle

import pytest

from pointpred import errors

KINDS = [
    kind
    for _, kind in inspect.getmembers(errors, inspect.isclass)
    if issubclass(kind, errors.PointpredError) and kind is not errors.ColumnsError
]


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_error_carries_its_data_through_a_pickle(kind: type[errors.PointpredError]) -> None:
    error = pickle.loads(pickle.dumps(kind("a sentence", code="a_code", field="cpi", value=-1.0)))
    assert (str(error), error.code, error.field, error.value) == ("a sentence", "a_code", "cpi", -1.0)


def test_codes_are_different() -> None:
    assert len({kind.code for kind in KINDS}) == len(KINDS)
