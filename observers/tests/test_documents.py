"""Plants and designs as JSON: nothing is lost, nothing unproved comes back, and errors name the field."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pointpred_observers as o
from observers.tests import kept_designs as kept
from pointpred.errors import CertificateError, InfeasibleError, ParameterError
from pointpred_observers.files import VERSION, decoded, encoded
from pointpred_observers.plants.entries import parsed, text_of
from pointpred_observers.plants.persidskii import NAMES

pytest.importorskip("cvxpy")

NUMBERS = st.floats(allow_nan=False, allow_infinity=False)
SIZES = st.integers(0, 3)


@st.composite
def plants(draw: Callable[..., Any]) -> o.Persidskii:
    """Persidskii plants of every size, f by names, with numbers of every size."""
    n, k, m, z, p = draw(st.integers(1, 3)), draw(SIZES), draw(SIZES), draw(SIZES), draw(SIZES)

    def entries(rows: int, columns: int) -> Any:
        return np.array(draw(st.lists(NUMBERS, min_size=rows * columns, max_size=rows * columns))).reshape(
            rows, columns
        )

    names = draw(st.lists(st.sampled_from(("sin", "tanh", "cube", "identity")), min_size=k, max_size=k))
    pairs = draw(st.none() | st.lists(st.tuples(NUMBERS, NUMBERS), min_size=k, max_size=k))
    return o.Persidskii(
        entries(n, n),
        entries(n, k),
        entries(k, n),
        names,
        entries(n, m),
        entries(n, z),
        entries(p, n) if p else None,
        entries(p, k) if p else None,
        # Wide enough for every name.
        slopes=[(min(-1.0, *pair), np.inf) for pair in pairs] if pairs and k else None,
        time=draw(st.sampled_from(("continuous", "discrete"))),
        domain=draw(st.just(np.inf) | st.floats(1e-300, 1e300)),
    )


@given(plants())
def test_a_plant_comes_back_bit_by_bit(plant: o.Persidskii) -> None:
    text = encoded(plant)
    again = decoded(text)
    for name in NAMES:
        assert getattr(plant, name).tobytes() == getattr(again, name).tobytes()
    assert (again.f.codes, again.slopes, again.domain, again.time) == (
        plant.f.codes, plant.slopes, plant.domain, plant.time,
    )  # fmt: skip
    assert encoded(again) == text


@pytest.mark.parametrize("name", kept.MAKERS)
def test_a_design_comes_back_with_every_number_and_proof(name: str, tmp_path: Path) -> None:
    design = kept.design(name)
    again = o.load(o.save(design, tmp_path / "design.json"))
    assert type(again) is type(design)
    assert encoded(again) == encoded(design)
    assert again.bounds == design.bounds
    assert again.gap == design.gap
    assert o.audit(again) == o.audit(design) == design.margins
    assert min(o.audit(design).values()) > -1e-9


@pytest.mark.parametrize("name", ["reduced order", "full order", "driven", "unknown input", "interlaced"])
def test_a_loaded_observer_runs_to_the_same_bits(name: str) -> None:
    design = kept.design(name)
    again = decoded(encoded(design))
    plant = {"reduced order": kept.PENDULUM, "full order": kept.PENDULUM, "driven": kept.DRIVEN,
             "unknown input": kept.WING, "interlaced": kept.SYMBOLIC}[name]  # fmt: skip
    first, second = (
        o.simulate(plant, one, times=np.arange(0.0, 0.5, 0.01), noise=0.1) for one in (design, again)
    )
    assert first.estimate.tobytes() == second.estimate.tobytes()


@pytest.mark.parametrize("name", ["reduced order", "full order", "regulator", "interlaced"])
def test_an_audit_refuses_a_bound_that_the_matrices_do_not_prove(name: str) -> None:
    design = kept.design(name)
    replace = msgspec.structs.replace
    if name == "full order":
        false = replace(design, bound=replace(design.bound, gains=(0.1, 0.1, 0.1)))
    elif name == "regulator":
        proof = design.feedback.certificate
        proof = replace(proof, bound=replace(proof.bound, overshoot=0.5))
        false = replace(design, feedback=replace(design.feedback, certificate=proof))
    else:
        bound = replace(design.certificate.bound, overshoot=0.5)
        false = replace(design, certificate=replace(design.certificate, bound=bound))
    assert o.audit(design)
    with pytest.raises(CertificateError, match="the design carries the bound ErrorBound"):
        o.audit(false)


def test_a_pi_that_overflows_proves_nothing() -> None:
    text = json.loads(encoded(kept.design("servo")))
    text["equations"]["Pi"][0][0] = 1e308
    with pytest.raises((CertificateError, ParameterError)):
        decoded(json.dumps(text))


def test_symbols_come_back_as_the_same_expressions() -> None:
    steady = kept.design("interlaced").steady
    for thing in (kept.SYMBOLIC, kept.CIRCLE, steady):
        again = decoded(encoded(thing))
        assert encoded(again) == encoded(thing)
    again = decoded(encoded(steady))
    assert (again.maps, again.input, again.exact) == (steady.maps, steady.input, steady.exact)


def test_what_a_person_writes_by_hand_is_read() -> None:
    text = """{"format": "pointpred observers", "version": 1, "kind": "plant",
               "A0": [[0, 1], [0, -1]], "A1": [0, 2], "H": [1, 0], "f": "tanh", "B": [0, 1], "C0": [1, 0]}"""
    plant = decoded(text)
    assert plant.A1.tolist() == [[0.0], [2.0]]
    assert plant.slopes == ((0.0, 1.0),)


def test_a_corner_system_is_the_function_between_and_beyond_the_corners() -> None:
    box = o.Box({"a": (1.0, 2.0), "still": (5.0, 5.0), "b": (-1.0, 3.0)})

    def a(p: Any) -> Any:
        return np.array([[p["a"], 1.0 + p["b"]], [p["a"] * p["b"], -1.0]])

    system = o.CornerSystem.of(o.ParameterVaryingSystem(a, [[1.0], [0.0]], [[1.0, 0.0]]), box)
    again = decoded(encoded(system))
    for point in ({"a": 1.0, "b": 3.0}, {"a": 1.3, "b": 0.7}, {"a": 5.0, "b": -9.0}):
        assert np.allclose(again.a(point), a(point), atol=1e-12)
        assert again.a(point).tobytes() == system.a(point).tobytes()
    assert again.f({}).tolist() == [[1.0], [0.0]]  # needs none of the variables
    with pytest.raises(ParameterError, match="affine"):
        o.CornerSystem.of(o.ParameterVaryingSystem(lambda p: a(p) ** 2, [[1.0], [0.0]], [[1.0, 0.0]]), box)


def growth(s: Any) -> Any:
    return s / (1.0 + np.abs(s))


def test_python_functions_are_passed_again() -> None:
    plant = o.Persidskii(
        lambda t: [[0.0, 1.0], [-1.0 - t, -0.1]],
        [0.0, -1.0],
        [1.0, 0.0],
        growth,
        C0=[1.0, 0.0],
        slopes=(0.0, 1.0),
    )
    text = encoded(plant)
    with pytest.raises(
        ParameterError, match=r"f was saved as the Python function 'growth'.*functions=\{'f'"
    ) as wrong:
        decoded(text, functions={"A0": plant.given("A0")}, name="plant.json")
    assert wrong.value.field == "f"
    again = decoded(text, functions={"f": growth, "A0": plant.given("A0")})
    assert np.array_equal(again.field(2.0, [0.3, -0.1]), plant.field(2.0, [0.3, -0.1]))
    design = o.design(plant.at(0.0), "full", decay=0.1)
    assert o.audit(design) == design.margins
    assert decoded(encoded(design), functions={"f": growth}).bound == design.bound


def changed(name: str, change: Callable[[dict[str, Any]], Any]) -> str:
    thing = {"plant": kept.PENDULUM, "wing": kept.WING, "circle": kept.CIRCLE}.get(name) or kept.design(name)
    content = json.loads(encoded(thing))
    change(content)
    return json.dumps(content)


def put(*path: Any, value: Any) -> Callable[[dict[str, Any]], None]:
    def change(content: dict[str, Any]) -> None:
        place: Any = content
        for key in path[:-1]:
            place = place[key]
        place[path[-1]] = value

    return change


WRONG = [
    ("plant", put("version", value=VERSION + 1), "version", "reads version 1: install a newer"),
    ("plant", put("version", value="1"), "version", '"version" must be 1'),
    ("plant", put("format", value="matlab"), "format", '"format" must be "pointpred observers"'),
    ("plant", put("kind", value="plan"), "kind", "must be one of plant, generator"),
    ("plant", put("A", value=[[1.0]]), "", "unknown field A; the fields are A0, A1"),
    ("plant", put("A0", 0, 1, value="fast"), "A0[0][1]", "Expected float, got str"),
    ("plant", put("B", value=[[1.0, 2.0]]), "B", "B has shape (1, 2), needs (2, any)"),
    ("plant", put("time", value="sometimes"), "time", "Invalid enum value 'sometimes'"),
    ("wing", lambda c: c["corners"].pop(), "corners", "the corner {'k': 3.0} of the box is missing"),
    ("wing", put("corners", 0, "A", value=[[1.0]]), "A", "same shape at every corner"),
    ("circle", put("field", 0, value="w2 +"), "", "'w2 +' is no expression"),
    ("circle", put("field", 0, value="__import__('os').getcwd()"), "", "is not known; an expression may"),
    ("circle", put("states", value=["w1", "sin"]), "sin", "needs a plain name"),
    ("full order", put("certificate", "Q", value=[[1.0]]), "", "certificate: Q is not known"),
    ("full order", lambda c: c["certificate"].pop("P"), "", "certificate: P is missing"),
    ("full order", put("certificate", "P", value=[[1.0]]), "certificate: P", "needs (2, 2)"),
    ("reduced order", put("certificate", "gamma", value=[[1.0]]), "", "gamma must be a number"),
]


@pytest.mark.parametrize(("name", "change", "field", "words"), WRONG, ids=[row[3][:40] for row in WRONG])
def test_a_wrong_file_is_refused_with_its_name_and_the_field(
    name: str, change: Callable[[dict[str, Any]], Any], field: str, words: str
) -> None:
    with pytest.raises(ParameterError) as wrong:
        decoded(changed(name, change), name="mine.json")
    assert str(wrong.value).startswith("mine.json: ")
    assert words in str(wrong.value).replace("`", "")
    assert wrong.value.field == field


@pytest.mark.parametrize("text", ["", "{", "[]", "3", '"plant"', "\x00", "[" * 100_000])
def test_what_is_no_document_is_refused(text: str) -> None:
    with pytest.raises(ParameterError):
        decoded(text)


TAMPERED = [
    ("full order", put("gain", value=[[0.1], [0.1]]), CertificateError),
    ("full order", put("Pi", value=[[1.0, 0.0], [0.0, 2.0]]), InfeasibleError),
    ("reduced order", put("Upsilon", value=[[3.0]]), CertificateError),
    ("reduced order, discrete", put("certificate", "P", value=[[-1.0]]), CertificateError),
    ("reduced order, discrete", put("certificate", "Xi", value=[[1e-100]]), CertificateError),
    (
        "full order, discrete",
        put("certificate", "Theta", value=(1e-100 * np.eye(2)).tolist()),
        CertificateError,
    ),
    ("driven", put("plant", "A0", value=[[-1.0, 0.5], [0.0, -1.0]]), InfeasibleError),
    ("regulator", put("regulator", "G", value=[[1.0], [1.0]]), InfeasibleError),
    ("regulator", put("feedback", "L0", value=[[0.0, 0.0]]), CertificateError),
    ("regulator", put("feedback", "decay", value=-3.0), ParameterError),
    ("regulator", put("observer", "plant", "B", value=[[0.0], [2.0]]), CertificateError),
    ("regulator", put("observer", "plant", "domain", value=1.0), CertificateError),
    ("unknown input", put("gains", value=[[[9.0], [-90.0]], [[9.0], [90.0]]]), CertificateError),
    ("unknown input", put("decay", value=2.5), CertificateError),
    ("interlaced", put("certificate", "U", value=[[-1.0], [0.0]]), CertificateError),
    ("interlaced", put("steady", "maps", 0, value="w1**2"), CertificateError),
]


@pytest.mark.parametrize(
    ("name", "change", "error"), TAMPERED, ids=[f"{row[0]} {i}" for i, row in enumerate(TAMPERED)]
)
def test_a_design_that_proves_nothing_is_not_loaded(
    name: str, change: Callable[[dict[str, Any]], Any], error: type[Exception]
) -> None:
    with pytest.raises(error, match=r"^mine\.json: "):
        decoded(changed(name, change), name="mine.json")


def test_a_regulator_without_j_in_its_file_has_that_of_its_plant() -> None:
    again = decoded(changed("regulator", lambda content: content["regulator"].pop("J")))
    assert np.array_equal(again.regulator.J, kept.PENDULUM.H @ again.Pi)
    assert np.isfinite(o.stage(again).update(0.0, [0.1, 0.0])).all()


def test_nothing_is_replaced_by_half_a_file(tmp_path: Path) -> None:
    target = o.save(kept.CART, tmp_path / "cart.json")
    before = target.read_bytes()
    for thing in (object(), o.ParameterVaryingSystem(np.eye(1), [[1.0]], [[1.0]])):
        with pytest.raises(ParameterError, match=r"can save|CornerSystem\.of"):
            o.save(thing, target)
    assert target.read_bytes() == before
    assert [one.name for one in tmp_path.iterdir()] == ["cart.json"]


@pytest.mark.parametrize("name", [None, 5, "", "folder", "missing/cart.json"])
def test_a_place_that_holds_no_file_is_refused(tmp_path: Path, monkeypatch: Any, name: Any) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    with pytest.raises(ParameterError, match=r"must be the path of a file|its folder must exist"):
        o.save(kept.CART, name)
    with pytest.raises(
        ParameterError, match=r"must be the path of a file|it is a folder|no such file"
    ) as wrong:
        o.load(name)
    assert wrong.value.field == "file"


sp = pytest.importorskip("sympy")


X, Y = sp.symbols("x y")


LEAVES = st.sampled_from([X, Y, sp.Integer(-3), sp.Rational(2, 7), sp.pi, sp.sqrt(2)])


EXPRESSIONS = st.recursive(
    LEAVES,
    lambda inner: st.one_of(
        st.builds(lambda a, b: a + b, inner, inner),
        st.builds(lambda a, b: a * b, inner, inner),
        st.builds(lambda a: a**3, inner),
        st.builds(lambda a: 1 / (1 + a**2), inner),
        st.builds(sp.sin, inner),
        st.builds(sp.tanh, inner),
    ),
    max_leaves=6,
)


@given(EXPRESSIONS)
def test_an_expression_comes_back(expression: sp.Expr) -> None:
    assert parsed(text_of(expression), "here") == expression


def test_decimals_are_exact() -> None:
    assert parsed("0.1*x", "here") * 10 == X
    assert parsed("1e-3", "here") == sp.Rational(1, 1000)


@pytest.mark.parametrize(
    "text",
    [
        "x.real", "x[0]", "lambda: 1", "[x]", "x if y else 1", "f(x)", "sin(x, y)", "sin(*x)", "x == 1",
        "x and y",
        "(x := 1)", "'a'", "1j", "True", "x @ y", "x % 2", "x // 2", "9**9**9",
        "2**(10**9 + 1/2)", "(1/3)**(-10**9 - 1/7)",
        "2**100000", "1e999", "sqrt(-1)", "log(0)", "((9**99)**99)**99",
        "1/0", "x/(1-1)", "import os", "", " ", "x" * 30_000, "(" * 500 + "x" + ")" * 500, "__import__('os')",
    ],
    ids=range(33),
)  # fmt: skip
def test_anything_else_is_refused(text: str) -> None:
    with pytest.raises(ParameterError, match="here"):
        parsed(text, "here")
