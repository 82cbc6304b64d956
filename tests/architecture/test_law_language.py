"""Laws are written in a small part of Python, so that they can be translated to another language.

docs/architecture.md, section "The law language", says in words what the translator takes. Loops that
``loop_of`` and ``loop_into`` make are exempt: they are not translated.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.architecture.tree import module_of, package_files
from translation.javascript import Law
from translation.source import UntranslatableError, module, parse

WITH_LAWS = [
    name for name in map(module_of, package_files()) if not name.endswith("__main__") and module(name).laws
]


@pytest.mark.parametrize("name", WITH_LAWS)
def test_laws_are_written_in_the_law_language(name: str) -> None:
    reader = module(name)
    for function in reader.laws.values():
        Law(reader, function)


@pytest.mark.parametrize(
    ("line", "construct"),
    [
        ("for x in (a, b): a = x", "for over (a, b)"),
        ("while a: a = 0\n    else: a = 1", "else of a loop"),
        ("a = [b]", "List"),
        ("a = {1: b}", "Dict"),
        ("a = 'word'", "constant 'word'"),
        ("a = lambda: b", "Lambda"),
        ("a = [x for x in b]", "ListComp"),
        ("a = b is None", "Is in b is None"),
        ("a = b >> 1", "RShift in b >> 1"),
        ("a = b.copy()", "call of b.copy"),
        ("a = sum(b)", "call of sum(b)"),
        ("a = np.linalg.inv(b)", "call of np.linalg.inv"),
        ("a = np.median(b)", "call of np.median(b)"),
        ("a = np.empty(3, dtype=bool)", "keyword in np.empty(3, dtype=bool)"),
        ("a = max(*b)", "* in max(*b)"),
        ("a: float = b", "AnnAssign"),
        ("try: a = b\n    except ValueError: a = 0", "Try"),
        ("print(a)", "call of print(a)"),
        ("a", "a value that is not used: a"),
        ("assert a", "Assert"),
        ("def inner(): return a", "FunctionDef"),
    ],
)
def test_another_construct_is_named_with_file_line_and_law(line: str, construct: str) -> None:
    source = f"import numpy as np\n@law\ndef step(a, b):\n    {line}\n    return a\n"
    with pytest.raises(UntranslatableError) as error:
        translated(source)
    assert str(error.value) == f"step.py:4: step: {construct}"


def translated(source: str, name: str = "step") -> str:
    reader = parse("pointpred.step", source, Path("step.py"), {name: None})
    return Law(reader, reader.laws[name]).text


def test_what_the_language_has_is_translated() -> None:
    source = """
from math import hypot, nan
import numpy as np
from pointpred.records import MotionRow
TABLE = (1.0, 2.0)
@law
def step(memory, motion):
    m = MotionRow(*motion)
    sums, counts = np.zeros(3), np.empty(2, dtype=np.int64)
    for i in range(len(sums)):
        if memory[i] != memory[i] or not m.x > 0.0:
            continue
        elif i & 1 == 0:
            break
        sums[i] += hypot(m.x, m.y) if i else nan
    while counts[0] < 3:
        counts[0] += 1
    memory[1:3] = 0.0
    return sums.shape[0], min(m.t, 1.0), np.pi
"""
    assert (
        translated(source)
        == """export function step(memory, motion) {
  const m = motion;
  const sums = new Float64Array(3);
  const counts = new Float64Array(2);
  for (let i = 0, end_1 = sums.length; i < end_1; i++) {
    if (memory[i] !== memory[i] || !(m[1] > 0)) {
      continue;
    } else if ((i & 1) === 0) {
      break;
    }
    sums[i] += i ? hypot(m[1], m[2]) : NaN;
  }
  while (counts[0] < 3) {
    counts[0] += 1;
  }
  memory.fill(0, 1, 3);
  return [sums.length, smaller(m[0], 1), Math.PI];
}"""
    )


@pytest.mark.parametrize(
    ("line", "javascript"),
    [
        ("a, b = b, a", ["const value_1 = b;", "const value_2 = a;", "a = value_1;", "b = value_2;"]),
        (
            "a[0], a[1] = a[1], a[0]",
            ["const value_1 = a[1];", "const value_2 = a[0];", "a[0] = value_1;", "a[1] = value_2;"],
        ),
        ("c = a // b", ["const c = Math.floor(a / b);"]),
        ("new = a % -b", ["const new_ = remainder(a, -b);"]),
        ("c = (a + b) ** 2", ["const c = square(a + b);"]),
        ("c = a - (b - a)", ["const c = a - (b - a);"]),
        ("c = 0.0 < a <= b", ["const c = 0 < a && a <= b;"]),
        ("c = not (a < b or a > b)", ["const c = !(a < b || a > b);"]),
        ("c = b[1:3]", ["const c = 1;"]),
        ("c = d = a", ["let c, d;", "c = d = a;"]),
        ("c = a[b[0] : b[1]]\n    d = len(c)", ["const c = view(a, b[0], b[1]);", "const d = c.length;"]),
        ("c = b if a else 2.0 if b else 3.0", ["const c = a ? b : b ? 2 : 3;"]),
        (
            "if a:\n        c = 1.0\n    else:\n        c = 2.0\n    a = c",
            ["let c;", "if (a) {", "  c = 1;", "} else {", "  c = 2;", "}", "a = c;"],
        ),
    ],
)
def test_what_means_something_else_in_javascript(line: str, javascript: list[str]) -> None:
    text = translated(f"@law\ndef step(a, b):\n    {line}\n    return a\n")
    assert [one[2:] for one in text.splitlines()[1:-2]] == javascript


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("c = a.x", ".x of a, which is not known to be a row with that part"),
        ("c = a[-1]", "an index from the end in a[-1]"),
        ("c = a[::2]", "a slice in steps"),
        ("for i in range(3): a = i\n    a = i", "i is used outside of its loop"),
        ("for i in range(0, 6, 2): a = i", "range in steps of 2"),
        ("c = a < int(b) < 3", "a call in the middle of a < int(b) < 3"),
        ("c = unknown", "the name unknown"),
        ("if f: c = a", "the float f as a condition: write what it is compared with"),
        ("c = a if not f else b", "the float f as a condition: write what it is compared with"),
        ("c = a > b and f", "the float f as a condition: write what it is compared with"),
    ],
)
def test_what_would_be_translated_wrongly_is_refused(line: str, reason: str) -> None:
    with pytest.raises(UntranslatableError, match="step") as error:
        translated(f"@law\ndef step(a, b, f: float):\n    {line}\n    return a\n")
    assert str(error.value).endswith(f"step: {reason}")
