"""The law language in C: it computes as Python does, and what it has not is refused."""

from __future__ import annotations

import ctypes
import math
import shutil
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from translation.c_law import Function
from translation.c_names import c_name, source_of
from translation.source import Name, UntranslatableError

GCC = shutil.which("gcc")
NUMBERS = {
    "quotient": "a / b",
    "down": "a // b",
    "rest": "a % b",
    "square": "(a - b) ** 2",
    "cube": "a ** 3",
    "inverse": "a ** -2",
    "largest": "max(a, b, 1.0)",
    "least": "min(a, b) + abs(a)",
    "between": "1.0 if 0.0 < a <= b else 2.0 if not a < b else 3.0",
    "either": "float(a < b or a > 2.0 and b > 0.0)",
    "away": "hypot(a, b) + copysign(1.0, a) * atan2(a, b)",
    "order": "a - (b - a) - -b",
    "octaves": "log2(a * a + 1.0)",
}
WHOLE = {"down_whole": "i // j", "rest_whole": "i % j", "bits": "(i & 12) + ~j", "parts": "i / j"}
LOOPS = '''
@law
def loops(memory: FloatArray, i: int, j: int) -> float:
    """Loops, a row, a slice and an exchange."""
    total, last = 0.0, Row(0.0, 1.0)
    for k in range(len(memory) - 1, -1, -1):
        if k == i % 5:
            continue
        memory[k], memory[0] = memory[0] + last.y, memory[k]
        last = Row(memory[k], last.x + 1.0)
    part = memory[1:4]
    part[1] += 2.0
    while total < 3.0:
        total += part[0] if part[0] > 0.5 else 1.0
        if total > 2.5:
            break
    for k in range(0, 5, 2):
        total += memory[k] * last.x
    memory[3:] = 0.5
    return total
'''
TURNS = """
@law
def take(memory: FloatArray) -> float:
    memory[0] += 1.0
    return memory[0]

@law
def turns(memory: FloatArray, i: int, j: int) -> float:
    total = atan2(take(memory), 3.0 * take(memory)) + take(memory) / (1.0 + take(memory))
    first, second, third = memory[0], take(memory), memory[0]
    memory[1] += take(memory) * memory[1]
    memory[2] -= take(memory)
    late = 1.0 if memory[0] < take(memory) else 2.0
    return total + (memory[0] - take(memory)) * 100.0 + first + 7.0 * second + 3.0 * third + 1000.0 * late
"""
"""Python computes from left to right; C would in any order."""
HEAD = """
from math import atan2, copysign, hypot, log2
from typing import NamedTuple
import numpy as np
from pointpred.records import FloatArray, FloatTable

class Row(NamedTuple):
    x: float
    y: float
"""
BIG = st.floats(-1e6, 1e6) | st.sampled_from([0.0, -0.0, 1.0, -1.0, math.inf, math.nan])


def source() -> str:
    laws = [
        f"@law\ndef {name}(a: float, b: float) -> float:\n    return {text}\n"
        for name, text in NUMBERS.items()
    ]
    laws += [
        f"@law\ndef {name}(i: int, j: int) -> {'float' if '/ ' in text and '//' not in text else 'int'}:\n"
        f"    return {text}\n"
        for name, text in WHOLE.items()
    ]
    return HEAD + "\n".join(laws) + LOOPS + TURNS


def loaded(text: str, name: str, folder: Path) -> dict[str, Any]:
    """A module of this source, as if it were one of the package; its laws are plain functions."""
    made = ModuleType(f"pointpred.{name}")
    made.__file__ = str(folder / f"{name}.py")
    Path(made.__file__).write_text(text, "utf-8")
    made.__dict__["law"] = lambda function: function
    sys.modules[made.__name__] = made
    exec(text, made.__dict__)
    return made.__dict__


def function_of(module: str, name: str) -> Function:
    def read(law: Any) -> Function:
        return Function(law, *source_of(law), read)

    return read(Name(f"pointpred.{module}", name))


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    return loaded(source(), "step", tmp_path_factory.mktemp("plain"))


@pytest.fixture(scope="module")
def compiled(tmp_path_factory: pytest.TempPathFactory, plain: dict[str, Any]) -> ctypes.CDLL:
    if GCC is None:
        pytest.skip("needs gcc")
    folder = tmp_path_factory.mktemp("laws")
    names = [*NUMBERS, *WHOLE, "loops", "take", "turns"]
    functions = [function_of("step", name) for name in names]
    structs = {kind.c: kind for one in functions for kind in one.structs.values()}
    lines = [(Path(__file__).parents[2] / "translation" / "c_prelude.h").read_text("utf-8")]
    for kind in structs.values():
        fields = " ".join(f"{one.c} {kind.field(i)};" for i, one in enumerate(kind.kinds))
        lines.append(f"typedef struct {{ {fields} }} {kind.c};")
    lines += [one.body for one in functions]
    (folder / "laws.c").write_text("\n".join(lines))
    command = [
        GCC,
        "-std=c11",
        "-O3",
        "-ffp-contract=off",
        "-shared",
        "-fPIC",
        "laws.c",
        "-lm",
        "-o",
        "laws.so",
    ]
    subprocess.run(command, cwd=folder, check=True)
    library = ctypes.CDLL(str(folder / "laws.so"))
    for name in names:
        getattr(library, c_name(Name("pointpred.step", name))).restype = ctypes.c_double
    for name in ("down_whole", "rest_whole", "bits"):
        getattr(library, c_name(Name("pointpred.step", name))).restype = ctypes.c_int64
    return library


def call(library: ctypes.CDLL, name: str, *arguments: Any) -> Any:
    return getattr(library, c_name(Name("pointpred.step", name)))(*arguments)


@pytest.mark.parametrize("name", NUMBERS)
def test_numbers_are_computed_as_in_python(compiled: ctypes.CDLL, plain: dict[str, Any], name: str) -> None:
    @settings(deadline=None, max_examples=200, derandomize=True)
    @given(BIG, BIG)
    def check(a: float, b: float) -> None:
        found = call(compiled, name, ctypes.c_double(a), ctypes.c_double(b))
        try:
            expected = plain[name](a, b)
        except (OverflowError, ZeroDivisionError):
            return  # in C an infinity or NaN, as the language says
        assert found == pytest.approx(expected, rel=1e-14, nan_ok=True)

    check()


@pytest.mark.parametrize("name", WHOLE)
def test_whole_numbers_are_computed_as_in_python(
    compiled: ctypes.CDLL, plain: dict[str, Any], name: str
) -> None:
    for i in range(-20, 20):
        for j in [one for one in range(-7, 8) if one]:
            assert call(compiled, name, ctypes.c_int64(i), ctypes.c_int64(j)) == plain[name](i, j)


@pytest.mark.parametrize("name", ["loops", "turns"])
def test_loops_rows_slices_and_calls_do_the_same_to_a_memory(
    compiled: ctypes.CDLL, plain: dict[str, Any], name: str
) -> None:
    import numpy as np

    class Vector(ctypes.Structure):
        _fields_ = [("p", ctypes.c_void_p), ("n", ctypes.c_int64)]

    for i in range(7):
        one = np.random.default_rng(i).normal(size=6)
        other = one.copy()
        given_one = Vector(one.ctypes.data, len(one))
        found = call(compiled, name, given_one, ctypes.c_int64(i), ctypes.c_int64(0))
        assert found == plain[name](other, i, 0)
        assert one.tolist() == other.tolist()


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("for x in (a, a): b = x", "for x in (a, a)"),
        ("c = [a]", "List"),
        ("c = lambda: a", "Lambda"),
        ("c = a is None", "Is in a is None"),
        ("c = sum(m)", "call of sum"),
        ("c = np.median(m)", "call of np.median"),
        ("try: c = a\n    except ValueError: c = 0.0", "Try"),
        ("c = m[a]", "an index that is no whole number: a"),
        ("c = m[-1]", "an index from the end in m[-1]"),
        ("c = m[0, 0]", "2 indices into Vector"),
        ("c = t[:, 0]", "a column of a table: t[:, 0]"),
        ("c = m.mean", ".mean of m, which is Vector"),
        ("if a: b = 1.0", "the float a as a condition"),
        ("c = a if a > 0.0 else m", "double and Vector under one name"),
        ("while len(np.zeros(int(a))) > 1: b = 1.0", "a new array within a condition"),
        ("for k in range(3): k = 2", "k is changed within its loop"),
        ("for a in range(3): b = 2.0", "the argument a as the variable of a loop"),
        ("c = 1 if len(m) and b > 0.0 else 2", "the number len(m) beside and, or"),
        ("c = 2 ** -len(m)", "a power of a whole number: 2 ** (-len(m))"),
        ("for k in range(3): c = np.zeros(k)", "an array whose size is not known within a loop"),
        ("for k in range(3): c = m.copy()", "an array whose size is not known within a loop"),
        ("c = unknown", "the name unknown"),
    ],
)
def test_what_c_would_do_otherwise_is_refused(line: str, reason: str, tmp_path: Path) -> None:
    arguments = "a: float, b: float, m: FloatArray, t: FloatTable"
    text = f"{HEAD}@law\ndef step({arguments}) -> float:\n    {line}\n    return a\n"
    name = f"wrong_{abs(hash(line))}"
    loaded(text, name, tmp_path)
    with pytest.raises(UntranslatableError) as error:
        function_of(name, "step")
    assert str(error.value).startswith(f"{tmp_path / name}.py:12: step: ")
    assert reason in str(error.value)
