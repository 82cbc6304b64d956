"""The names users type, and what each builds: the command line, the server, the scorer, the docs read it."""

from __future__ import annotations

import difflib
import inspect
import re
import warnings
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import cache, partial
from importlib.metadata import EntryPoint, entry_points
from typing import Any

import msgspec

from pointpred.differentiators import DIFFERENTIATORS
from pointpred.errors import ParameterError
from pointpred.parameter import Parameter
from pointpred.pipeline import Pipeline
from pointpred.predictors import (
    AdaptiveKinematicPredictor,
    DelphianPredictor,
    HoldPredictor,
    KalmanPredictor,
    KinematicEndpointPredictor,
    KinematicPredictor,
    LinearPredictor,
    MinimumJerkPredictor,
    Predictor,
    SwitchedDirectionPredictor,
    SwitchedPredictor,
    TemplatePredictor,
)
from pointpred.stage import CompiledStage
from pointpred.targets.aim import Aim
from pointpred.targets.rectangles import Target


class Entry(msgspec.Struct, frozen=True):
    """A name: its predictor, what it sets differently from the classes' defaults, and where it comes from."""

    name: str
    predictor: type[Predictor]
    title: str
    reference: str
    differentiator: str = "homogeneous"
    preset: dict[str, Any] = {}
    make: Callable[..., Any] | None = None
    """What makes it, where that is a function of another package and no class of ours; see ``made``."""


LONGEST_COMPARED = 64
"""Characters of an unknown word that are compared with the known ones."""
GAINS = {"gain_lambda": 48.0, "gain_xi": 1.6, "alpha": 0.0}
"""The differentiator's gains of every name that sets no others: one choice for ours and the baselines."""

PRINTED = {"gain_lambda": 5.0, "gain_xi": 2.0, "alpha": -0.2, "threshold": 0.2, "bound": 0.1}
"""The thesis's values; its delay and rate of regression are not printed: the class's defaults stand in."""

RECOMMENDED = "kinematic-adaptive"
"""The name for a live person: the page, both clients, the command line and assistance begin with it."""

TUNED_SWITCHED = {"threshold": 0.08, "bound": 1.0, "delay_s": 0.011, "gamma": 6.5e7}

REGISTRY: dict[str, Entry] = {
    entry.name: entry
    for entry in (
        Entry("hold", HoldPredictor, "no prediction: the cursor's own position", "the floor"),
        Entry("linear", LinearPredictor, "constant velocity over a fixed horizon", "ForesightJS"),
        Entry("kalman", KalmanPredictor, "constant acceleration over a fixed horizon, filtered", "Chromium"),
        Entry(
            "minimum-jerk", MinimumJerkPredictor, "minimum-jerk inversion, no training", "Flash, Hogan 1985"
        ),
        Entry(
            "delphian",
            DelphianPredictor,
            "once past the speed peak, as far as a line through the peak speed says",
            "Asano and others 2005",
        ),
        Entry(
            "kep-quadratic",
            KinematicEndpointPredictor,
            "where a quadratic of speed over distance returns to zero",
            "Ruiz, Lank 2009, without its stability check",
            preset={"degree": 2},
        ),
        Entry(
            "kep-quadratic-gated",
            KinematicEndpointPredictor,
            "where a quadratic of speed over distance returns to zero, once that is stable",
            "Ruiz, Lank 2009",
            preset={"degree": 2, "change_most": 0.02},
        ),
        Entry(
            "kep-quartic",
            KinematicEndpointPredictor,
            "where a quartic of speed over distance returns to zero",
            "Lank, Cheng, Ruiz 2007, without its coefficients c_k",
            preset={"degree": 4},
        ),
        Entry(
            "kep-quartic-gated",
            KinematicEndpointPredictor,
            "where a quartic of speed over distance returns to zero, once that is stable",
            "Lank, Cheng, Ruiz 2007 with the stability check of Ruiz, Lank 2009",
            preset={"degree": 4, "change_most": 0.02},
        ),
        Entry(
            "ktm",
            TemplatePredictor,
            "as far as the session's earlier movement whose speed profile is most alike",
            "Pasqual, Wobbrock 2014",
        ),
        Entry(
            "switched",
            SwitchedPredictor,
            "doubling while the hand accelerates, DREM while it corrects; tuned",
            "Khalin 2022, section 2.5.6",
            preset=TUNED_SWITCHED,
        ),
        Entry(
            "switched-printed",
            SwitchedPredictor,
            "switched with the gains, threshold and bound as printed",
            "Khalin 2022, sections 2.3.2 and 2.5.6",
            preset=PRINTED,
        ),
        Entry(
            "switched-direction",
            SwitchedDirectionPredictor,
            "one sub-movement after the other along its direction: doubling, then an approach that converges",
            "Khalin 2022, sections 2.4.2, 2.4.3 and 2.5.6, changed",
            preset={"gain_lambda": 100.0},
        ),
        Entry(
            "kinematic",
            KinematicPredictor,
            "learned from people: endpoint, region, tail and time left from the movement so far",
            "docs/evidence/results.md",
        ),
        Entry(
            "kinematic-adaptive",
            AdaptiveKinematicPredictor,
            "kinematic, corrected by what the person's earlier movements taught",
            "docs/guide/adaptation.md",
        ),
    )
}


@cache
def others() -> dict[str, EntryPoint]:
    """The predictors of other packages by name: entry points of the group ``pointpred.predictors``.

    Nothing is imported. The name of an entry point is the predictor's; a name of ours cannot be taken.
    """
    found: dict[str, EntryPoint] = {}
    for one in entry_points(group="pointpred.predictors"):
        if one.name in REGISTRY or one.name in found:
            warnings.warn(
                f"the predictor {one.name!r} of {package_of(one)} has a name that is taken", stacklevel=3
            )
        else:
            found[one.name] = one
    return found


def package_of(found: EntryPoint) -> str:
    """The package and version of an entry point, and its object."""
    package = f"{found.dist.name} {found.dist.version}" if found.dist else found.module
    return f"{package} ({found.value})"


def load(name: str) -> Entry:
    """Import a predictor of another package, make it once, and enter it into REGISTRY.

    Its object is a subclass of ``Predictor``, or a callable that makes a ``Predictor``, a ``Pipeline``, or an
    object of plain Python as ``PlainPredictor`` takes it. Raises ParameterError that names the package.
    """
    found = others()[name]
    try:
        predictor = found.load()
        if not callable(predictor):
            raise TypeError(f"it must be callable, received {predictor!r}")
        title = (inspect.getdoc(predictor) or found.value).splitlines()[0].rstrip(".")
        package = package_of(found).partition(" (")[0]
        if isinstance(predictor, type) and issubclass(predictor, Predictor):
            entry = Entry(name, predictor, title, package)
        else:
            entry = Entry(name, Predictor, title, package, make=predictor)
            entry = msgspec.structs.replace(entry, predictor=type(made(entry, {}, {}).predictor))
    except (Exception, SystemExit) as error:  # whatever a foreign package raises
        why = f"{type(error).__name__}: {error}" if not isinstance(error, ParameterError) else error
        message = f"the predictor {name!r} of {package_of(found)} cannot be used: {why}"
        raise ParameterError(message, code="unknown_predictor", field="predictor", value=name) from error
    REGISTRY[name] = entry
    return entry


def find_others() -> list[str]:
    """Enter every predictor of other packages into REGISTRY; returns what is wrong with those left out."""
    wrong = []
    for name in [one for one in others() if one not in REGISTRY]:
        try:
            load(name)
        except ParameterError as error:
            wrong.append(str(error))
    return wrong


def made(entry: Entry, settings: Mapping[str, Any], resolution: Mapping[str, Any]) -> Pipeline:
    """The pipeline of what a function of another package makes.

    ``settings`` go to the function or to the differentiator, ``resolution`` (cpi, dpi) also to the function
    where it takes them. Raises ParameterError for what neither takes.
    """
    assert entry.make is not None
    taken = inspect.signature(entry.make).parameters
    anything = any(one.kind is inspect.Parameter.VAR_KEYWORD for one in taken.values())
    shared = _names(DIFFERENTIATORS[entry.differentiator])
    for word in settings:
        if not anything and word not in (*taken, *shared):
            raise _unknown(f"parameter of {entry.name}", word, word, [*taken, *shared])
    own = {
        word: value for word, value in settings.items() if word in taken or (anything and word not in shared)
    }
    make = partial(entry.make, **own, **{word: value for word, value in resolution.items() if word in taken})
    one = make()
    if isinstance(one, Pipeline):
        for word in settings.keys() - own.keys():
            raise _unknown(f"parameter of {entry.name}", word, word, list(taken))
        one.name = entry.name
        return one
    if not isinstance(one, Predictor):
        if not all(callable(getattr(one, word, None)) for word in ("update", "reset")):
            expected = "a Pipeline, a Predictor, or an object with update(motion) and reset()"
            raise ParameterError(f"it must make {expected}, made {one!r:.80}", field="predictor")
        from pointpred.predictors.plain import PlainPredictor

        one = PlainPredictor(make)
    rest = GAINS | {word: value for word, value in settings.items() if word not in own} | dict(resolution)
    values = {word: value for word, value in rest.items() if word in shared}
    return Pipeline(entry.name, DIFFERENTIATORS[entry.differentiator](**values), one)


def settings_in(spelled: str) -> tuple[str, dict[str, Any]]:
    """A name and what is set behind it, each after a colon; values are numbers, or words.

    >>> settings_in("kinematic-adaptive:places=0:distances=0")
    ('kinematic-adaptive', {'places': 0, 'distances': 0})
    """
    name, *parts = re.split(r":(?=\s*\w+\s*=)", spelled)
    settings: dict[str, Any] = {}
    for part in parts:
        word, _, text = (piece.strip() for piece in part.partition("="))
        settings[word] = text
        for kind in (float, int):  # the last that fits
            with suppress(ValueError):
                settings[word] = kind(text)
    return name.strip(), settings


def ablation(spelled: str) -> str | None:
    """The same predictor without its memory of ends and distances; ``None`` where it has none.

    Words in brackets behind a name stay there.

    >>> ablation("kinematic-adaptive:shortest_px=5"), ablation("linear"), ablation("my own")
    ('kinematic-adaptive:shortest_px=5:places=0:distances=0', None, None)
    """
    spelled, bracket, words = spelled.partition(" (")
    name, settings = settings_in(spelled)
    if name not in REGISTRY:
        return None
    without = {**settings, **_entry(name).predictor.without_memory}
    if without == settings or not build(name, **settings).learns:
        return None
    return ":".join([name, *(f"{word}={value}" for word, value in without.items())]) + bracket + words


def parameters(name: str) -> dict[str, tuple[Parameter, Any]]:
    """Every parameter of a name with its value unless set otherwise, predictor's first."""
    entry = _entry(name)
    preset = GAINS | entry.preset
    stages: tuple[type[CompiledStage], ...] = (entry.predictor, DIFFERENTIATORS[entry.differentiator])
    if entry.make is not None:  # what it takes is not declared
        stages = ()
    return {
        one.name: (one, preset.get(one.name, one.default)) for stage in stages for one in stage.parameters
    }


def takes(name: str, parameter: str) -> bool:
    """Whether the predictor of a name has a parameter; raises ParameterError for an unknown name."""
    return parameter in _names(_entry(name).predictor)


def describe(name: str) -> dict[str, Any]:
    """A predictor as the JSON, the terminal and the docs show it."""
    entry = REGISTRY[name]
    settable = [
        {
            "name": parameter.name,
            "unit": parameter.unit,
            "low": parameter.low,
            "high": parameter.high,
            "default": default,
            "meaning": parameter.meaning,
            "of": "predictor" if parameter in entry.predictor.parameters else "differentiator",
        }
        for parameter, default in parameters(name).values()
    ]
    return {
        "name": name,
        "title": entry.title,
        "reference": entry.reference,
        "differentiator": entry.differentiator,
        "parameters": settable,
    }


def build(
    name: str,
    *,
    cpi: float | None = None,
    dpi: float = 96.0,
    person: str = "",
    targets: Sequence[Target] = (),
    **parameters: Any,
) -> Pipeline:
    """Return a fresh pipeline for a name of the registry.

    ``cpi``: counts per inch of the device; with it motor motion comes from the events' counts, without it
    from the cursor and ``dpi`` (px per inch). Other parameters go to the predictor, the differentiator or the
    ``Aim`` that has them; ``differentiator`` names another differentiator. ``person``: what
    ``Pipeline.person`` of the same predictor was, to go on with what is known of that person; "" knows
    nobody. ``targets``: what can be pointed at, as ``Pipeline.register`` takes it. Raises ParameterError.

    >>> build("hold").name
    'hold'
    >>> build("kinematic-adaptive").person  # nobody has moved yet
    ''
    """
    entry = _entry(name)
    if entry.make is not None:
        pipeline = made(entry, parameters, {"cpi": cpi, "dpi": dpi})
        pipeline.person = person
        if targets:
            pipeline.register(targets)
        return pipeline
    chosen = parameters.pop("differentiator", entry.differentiator)
    if not isinstance(chosen, str) or chosen not in DIFFERENTIATORS:
        raise _unknown("differentiator", "differentiator", chosen, list(DIFFERENTIATORS))
    own, shared, of_targets = _names(entry.predictor), _names(DIFFERENTIATORS[chosen]), _names(Aim)
    for word in parameters:
        if word not in own + shared + of_targets:
            error = _unknown(f"parameter of {name}", word, word, own + shared + of_targets)
            error.value = parameters[word]
            raise error
    settings = GAINS | entry.preset | parameters | {"cpi": cpi, "dpi": dpi}
    predictor = entry.predictor(**{key: settings[key] for key in own if key in settings})
    differentiator = DIFFERENTIATORS[chosen](**{key: settings[key] for key in shared if key in settings})
    pipeline = Pipeline(name, differentiator, predictor)
    if parameters.keys() & set(of_targets):
        pipeline.aim = Aim(**{key: parameters[key] for key in of_targets if key in parameters})
    pipeline.person = person
    if targets:
        pipeline.register(targets)
    return pipeline


def _names(stage: type[CompiledStage]) -> list[str]:
    return [one.name for one in stage.declarations]


def _entry(name: str) -> Entry:
    if isinstance(name, str) and name not in REGISTRY and name in others():
        return load(name)
    if not isinstance(name, str) or name not in REGISTRY:
        raise _unknown("predictor", "predictor", name, [*REGISTRY, *others()])
    return REGISTRY[name]


def _unknown(kind: str, field: str, name: object, known: list[str]) -> ParameterError:
    """The error for a word that names nothing, with a code such as ``unknown_predictor``."""
    near = difflib.get_close_matches(str(name)[:LONGEST_COMPARED], known, 1)
    hint = f"; did you mean {near[0]!r}?" if near else "."
    message = f"unknown {kind} {name!r}{hint} Known: {', '.join(known)}"
    return ParameterError(message, code=f"unknown_{kind.split()[0]}", field=field, value=name)
