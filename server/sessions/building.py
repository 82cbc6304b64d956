"""A pipeline as a client asked for it; what is wrong with the wish, and where it says so."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.errors import ParameterError
from pointpred.person import restore
from pointpred.pipeline import Pipeline
from pointpred.predictors.kinematic import coefficient_file
from pointpred.protocol.client_messages import Hello, Setting
from pointpred.protocol.errors import ProtocolError
from pointpred.registry import REGISTRY, build, takes

DPI = 96.0
COEFFICIENTS = "coefficients"
NO_COEFFICIENTS: Mapping[str, Path] = {}
ELSEWHERE = {"cpi": "device.cpi", "dpi": "screen.dpi", "name": "predictor", "person": "person"}
"""What ``build`` takes besides parameters, and where a client says it."""
SUBSTEPS_MOST = 200
"""Sub-steps that one event may take in a session: some 15 us, where an event without any takes one."""


def cpi_of(hello: Hello) -> float | None:
    """Counts per inch of the client's device; ``None`` where it does not say."""
    return hello.device.cpi if hello.device else None


def dpi_of(hello: Hello) -> float:
    """Pixels per inch of the client's screen."""
    return hello.screen.dpi if hello.screen else DPI


def pipeline_of(hello: Hello, coefficients: Mapping[str, Path] = NO_COEFFICIENTS) -> Pipeline:
    """A fresh pipeline that knows the person the client named.

    ``coefficients``: the files that a client may ask for by name; it never names a path.

    Raises ProtocolError, naming what is known, for an unknown predictor, a wrong parameter or a person that
    the predictor cannot take.
    """
    if hello.predictor not in REGISTRY:
        words = f"unknown predictor {hello.predictor!r}; known: {', '.join(REGISTRY)}"
        raise ProtocolError("unknown_predictor", words, "$.predictor")
    for name, place in ELSEWHERE.items():
        if name in hello.parameters:
            raise ProtocolError("bad_field", f"{name} is said as {place}", f"$.parameters.{name}")
    try:
        settings: dict[str, Any] = {name: _whole(value) for name, value in hello.parameters.items()}
        if COEFFICIENTS in settings and takes(hello.predictor, COEFFICIENTS):
            settings[COEFFICIENTS] = _file_of(settings[COEFFICIENTS], coefficients)
        pipeline = build(hello.predictor, cpi=cpi_of(hello), dpi=dpi_of(hello), **settings)
        _check_substeps(pipeline)
    except ParameterError as error:
        raise ProtocolError("bad_field", str(error), _place(str(error), hello)) from None
    except (TypeError, ValueError) as error:
        given = list(hello.parameters)
        path = f"$.parameters.{given[0]}" if len(given) == 1 else "$.parameters"
        raise ProtocolError("bad_field", f"a parameter is of a wrong type: {error}", path) from None
    try:
        restore(pipeline.predictor, hello.person)
    except ParameterError as error:
        raise ProtocolError("bad_field", str(error), "$.person") from None
    return pipeline


def _file_of(name: Setting, coefficients: Mapping[str, Path]) -> Path:
    """The file of coefficients of a name; raises ProtocolError, which does not contain the path."""
    path = f"$.parameters.{COEFFICIENTS}"
    if not isinstance(name, str) or name not in coefficients:
        known = ", ".join(sorted(coefficients)) or "none; the service names them when it is started"
        raise ProtocolError("bad_field", f"unknown coefficients {name!r}; known: {known}", path)
    try:
        coefficient_file.read(coefficients[name])
    except ParameterError:
        words = f"the coefficients {name!r} cannot be read any more; ask who runs the service"
        raise ProtocolError("bad_field", words, path) from None
    return coefficients[name]


def _check_substeps(pipeline: Pipeline) -> None:
    """Raise ParameterError where one event may cost so much that every other session would wait for it."""
    differentiator = pipeline.differentiator
    if not isinstance(differentiator, HomogeneousDifferentiator):
        return
    gap_s, step_s = differentiator.gap_s, differentiator.step_s
    if gap_s > SUBSTEPS_MOST * step_s:
        raise ParameterError(
            f"step_s must be at least gap_s / {SUBSTEPS_MOST} = {gap_s / SUBSTEPS_MOST:g} s in a session, "
            f"received step_s = {step_s!r} s with gap_s = {gap_s!r} s",
            field="step_s",
            value=step_s,
        )


def _whole(value: Setting) -> Setting:
    """JSON does not tell 4.0 from 4; a parameter that counts wants the latter, the others take both."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


def _place(words: str, hello: Hello) -> str:
    """The path of the parameter that an error speaks of first."""
    found = {name: _mentioned(name, words) for name in hello.parameters}
    named = [name for name, at in found.items() if at >= 0]
    return f"$.parameters.{min(named, key=found.__getitem__)}" if named else "$.parameters"


def _mentioned(name: str, words: str) -> int:
    """Where words mention a parameter, -1 where they do not: quoted where it is unknown, else as a word."""
    if (quoted := words.find(repr(name))) >= 0:
        return quoted
    found = re.search(rf"\b{re.escape(name)}\b", words)
    return found.start() if found else -1
