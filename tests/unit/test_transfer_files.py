"""Transfer functions in files and in words, and polynomials made safe to move a cursor with."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import pytest

from pointpred.errors import ParameterError, RecordingError
from pointpred.transfer import (
    Arctan,
    ConstantGain,
    HeldPolynomial,
    PixelTransfer,
    PolynomialFunction,
    SigmoidGain,
    TransferFunction,
    load_transfer,
    named_transfer,
    save_transfer,
)

CPI, DPI = 2000.0, 96.0
SMOOTH = PolynomialFunction([0.0, 1.0, 20.0, -40.0], speed_low=0.0127, speed_high=0.31)


@pytest.mark.parametrize("function", [ConstantGain(3.0), SigmoidGain(2.0, 9.0, 0.1, 0.4), SMOOTH])
def test_a_file_keeps_the_function_and_its_resolutions(function: TransferFunction, tmp_path: Path) -> None:
    path = tmp_path / "function.json"
    save_transfer(path, function, cpi=1600.0, dpi=110.0)
    assert json.loads(path.read_text())["version"] == 1
    back = load_transfer(path)
    assert (back.cpi, back.dpi) == (1600.0, 110.0)
    speeds = np.linspace(0.0127, 0.31, 50)
    assert back.function.gain(speeds) == pytest.approx(function.gain(speeds), rel=1e-12)
    assert named_transfer(str(path)).cpi == 1600.0
    with pytest.raises(ParameterError, match="exists"):
        save_transfer(path, function)
    save_transfer(path, ConstantGain(1.0), replace=True)
    assert float(load_transfer(path).function.gain(0.1)) == 1.0
    assert os.listdir(tmp_path) == ["function.json"]  # noqa: PTH208


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("{", "truncated"),
        ("\x00", "malformed"),
        ('{"version": 2, "kind": "constant", "numbers": [1]}', "version must be 1"),
        ('{"version": 1, "kind": "constant", "numbers": []}', "expected 1 numbers, received 0"),
        ('{"version": 1, "kind": "sigmoid", "numbers": [1, 2, 3]}', "expected 4 numbers"),
        ('{"version": 1, "kind": "polynomial", "numbers": [0, 1]}', "needs speed_low"),
        ('{"version": 1, "kind": "constant", "numbers": [-1]}', "gain must lie"),
        ('{"version": 1, "kind": "constant", "numbers": [1], "cpi": -5}', "cpi and dpi"),
        ('{"version": 1, "kind": "constant", "numbers": [1], "more": 1}', "unknown field"),
        (" " * 70000, "longer than"),
    ],
)
def test_a_file_of_anything_else_is_refused_by_name(text: str, why: str, tmp_path: Path) -> None:
    path = tmp_path / "other.json"
    path.write_text(text)
    with pytest.raises(RecordingError, match=f"other.json: not a saved transfer function: .*{why}"):
        load_transfer(path)


def test_what_cannot_move_a_cursor_is_not_saved(tmp_path: Path) -> None:
    for function in (
        Arctan(),
        PolynomialFunction([0.0, 1.0]),
        PolynomialFunction([1.0, 1.0], speed_high=1.0),
    ):
        with pytest.raises(ParameterError):
            save_transfer(tmp_path / "function.json", function)
    assert list(tmp_path.iterdir()) == []


def test_words_name_a_function() -> None:
    assert float(named_transfer("constant:2.5").function.gain(0.1)) == 2.5
    assert named_transfer("sigmoid").function.slots.tolist() == SigmoidGain().slots.tolist()
    assert named_transfer("sigmoid:1,3,0.1,0.2").function.slots.tolist()[1:5] == [1.0, 3.0, 0.1, 0.2]
    for words in ("constant", "constant:x", "constant:1,2", "sigmoid:1", "curve", "no/such/file"):
        with pytest.raises(ParameterError, match="expected 'constant:GAIN', 'sigmoid'"):
            named_transfer(words)


def test_a_held_polynomial_stays_tame_beyond_its_range() -> None:
    wild = PolynomialFunction([0.0, 1.0, 20.0, -40.0, 0.0, -300.0], speed_low=0.02, speed_high=0.3)
    held = HeldPolynomial(wild)
    inside = np.linspace(0.02, 0.3, 30)
    assert held.gain(inside) == pytest.approx(wild.gain(inside), rel=1e-12)
    assert held.cursor_speed(inside) == pytest.approx(wild.cursor_speed(inside), rel=1e-12)
    assert held.gain([0.0, 2.0]).tolist() == pytest.approx([float(wild.gain(0.02)), float(wild.gain(0.3))])
    assert float(wild.gain(2.0)) < 0.0 < float(held.gain(2.0))
    forward = PixelTransfer(held, cpi=CPI, dpi=DPI).run(np.arange(3) / 1000, np.full(3, 400.0), np.zeros(3))
    assert (forward[:, 0] > 0.0).all()
    with pytest.raises(ParameterError, match="c_0 = 0 and order 1 to 5"):
        HeldPolynomial(PolynomialFunction([0.0] * 6 + [1.0], speed_high=1.0))
