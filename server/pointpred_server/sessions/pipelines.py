"""The pipeline that a client asks for, or the error that says what is wrong in its hello."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pointpred.differentiators import HomogeneousDifferentiator
from pointpred.errors import ParameterError
from pointpred.pipeline import Pipeline
from pointpred.predictors.kinematic import coefficient_file
from pointpred.protocol.client_messages import Hello, Setting, cpi_of, dpi_of
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.server_messages import Code
from pointpred.registry import build, takes

COEFFICIENTS = "coefficients"
NO_COEFFICIENTS: Mapping[str, Path] = {}
ELSEWHERE = {"cpi": "device.cpi", "dpi": "screen.dpi", "name": "predictor", "person": "person"}
"""What ``build`` takes besides parameters, and where in a hello it belongs."""
PARAMETERS_MOST = 64
"""Parameters of one message; no predictor takes half as many."""
MEMORY_MOST = 2**20
"""Bytes that the stages of a session remember: they are copied for each frame."""
SUBSTEPS_MOST = 200
"""Sub-steps that one event may take in a session: they take some 15 us, an event without any takes 1 us."""


def pipeline_of(hello: Hello, coefficients: Mapping[str, Path] = NO_COEFFICIENTS) -> Pipeline:
    """A fresh pipeline that knows the person of the client's hello.

    ``coefficients``: the files that a client may ask for by name; it never names a path.

    Raises ProtocolError for an unknown predictor, a wrong parameter or an unusable person.
    """
    try:
        settings = _settings(hello, coefficients)
        pipeline = build(hello.predictor, cpi=cpi_of(hello), dpi=dpi_of(hello), **settings)
        _check_substeps(pipeline)
        _check_memory(pipeline)
    except ParameterError as error:
        raise _refusal(error, _path(error, hello)) from None
    try:
        pipeline.person = hello.person
    except ParameterError as error:
        raise _refusal(error, "$.person") from None
    return pipeline


def _settings(hello: Hello, coefficients: Mapping[str, Path]) -> dict[str, Any]:
    """The parameters of a hello, as ``build`` takes them; raises ParameterError or ProtocolError."""
    if (count := len(hello.parameters)) > PARAMETERS_MOST:
        sentence = f"at most {PARAMETERS_MOST} parameters, received {count}"
        raise ProtocolError("too_many", sentence, "$.parameters")
    by_name = takes(hello.predictor, COEFFICIENTS)
    for name, place in ELSEWHERE.items():
        if name in hello.parameters:
            sentence = f"{name} is no parameter of a predictor; it belongs to {place}"
            raise ProtocolError(
                "bad_field", sentence, f"$.parameters.{name}", field=name, value=hello.parameters[name]
            )
    settings: dict[str, Any] = {name: _whole(value) for name, value in hello.parameters.items()}
    if by_name and COEFFICIENTS in settings:
        settings[COEFFICIENTS] = _file_of(settings[COEFFICIENTS], coefficients)
    return settings


def _refusal(error: ParameterError, path: str) -> ProtocolError:
    code: Code = "unknown_predictor" if error.code == "unknown_predictor" else "bad_field"
    return ProtocolError(code, str(error), path, field=error.field, value=error.value)


def _file_of(name: Setting, coefficients: Mapping[str, Path]) -> Path:
    """The file of coefficients of a name; raises ProtocolError, which does not contain the path."""
    path = f"$.parameters.{COEFFICIENTS}"
    if not isinstance(name, str) or name not in coefficients:
        known = ", ".join(sorted(coefficients)) or "none; the service names them when it is started"
        sentence = f"unknown coefficients {name!r}; known: {known}"
        raise ProtocolError("bad_field", sentence, path, field=COEFFICIENTS, value=name)
    try:
        coefficient_file.read(coefficients[name])
    except ParameterError:
        sentence = f"the coefficients {name!r} can no longer be read; ask the person who runs the service"
        raise ProtocolError("bad_field", sentence, path, field=COEFFICIENTS, value=name) from None
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


def _check_memory(pipeline: Pipeline) -> None:
    """Raise ParameterError where a pipeline remembers more than a session may: templates can."""
    size = pipeline.differentiator.memory_bytes + pipeline.predictor.memory_bytes
    if size > MEMORY_MOST:
        raise ParameterError(
            f"a session may remember at most {MEMORY_MOST} bytes, these parameters need {size}: "
            "fewer templates, or a shorter longest_s, need less",
            field="templates",
            value=getattr(pipeline.predictor, "templates", None),
        )


def _whole(value: Setting) -> Setting:
    """A whole float as an int: in JSON 4.0 may be 4, and some parameters accept whole numbers only."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


def _path(error: ParameterError, hello: Hello) -> str:
    """Where in a message the parameter stands that an error is about.

    An error about how several parameters go together names one of them, which may be a default.
    """
    if error.code == "unknown_predictor":
        return "$.predictor"
    if error.field in hello.parameters:
        return f"$.parameters.{error.field}"
    names = list(hello.parameters)
    return f"$.parameters.{names[0]}" if len(names) == 1 else "$.parameters"
