"""What the pages of docs/reference show that are made from the code: a context a page.

Errors, commands, monitoring, predictors and settings, the OpenAPI document, and the README's scores.
"""

from __future__ import annotations

import inspect
import json
from collections.abc import Iterator
from typing import Any

import msgspec
import typer
from prometheus_client import CollectorRegistry, Metric

from evidence import data
from evidence.reference.asyncapi import CLOSES, CODES
from evidence.results.page import overall
from evidence.results.records import stored
from pointpred import errors
from pointpred.cli.app import DONE, INTERRUPTED, NOTHING, WRONG_USE, LazyCommand, app
from pointpred.cli.help_text import VALUES
from pointpred.cli.reading_options import PANEL, TABLES
from pointpred.differentiators import DIFFERENTIATORS
from pointpred.errors import PointpredError
from pointpred.logs import FIELDS
from pointpred.parameter import Parameter
from pointpred.registry import GAINS, RECOMMENDED, REGISTRY, describe
from pointpred.registry import parameters as values_of
from pointpred.scoring import FLOOR
from pointpred_server.app import create_app
from pointpred_server.cli.serve import FLAGS
from pointpred_server.logs import EVERY_ENTRY
from pointpred_server.metrics import Metrics
from pointpred_server.settings import Settings

OF_PROCESS = "process_", "python_"
"""The beginnings of the names of metrics that are not of pointpred."""
UNITS = {"_seconds": "s", "_bytes": "bytes", "_info": ""}
"""Of a metric, by the end of its name; other metrics count."""
IN_README = {
    "`hold`": "`hold`: no prediction",
    "`minimum-jerk`": "`minimum-jerk`: has learned from nobody",
    "`kinematic`": "`kinematic`: has learned from other people",
    "`kinematic-adaptive`": "`kinematic-adaptive`: learns from the person, too",
    "oracle": "an oracle: knows how far it goes, keeps the direction",
}
"""Columns of the errors with targets, and what they are called in the README."""


class Setting(msgspec.Struct, frozen=True):
    """An argument or an option."""

    name: str
    default: str
    meaning: str


class Command(msgspec.Struct, frozen=True):
    """A command as it is typed."""

    name: str
    summary: str
    settings: tuple[Setting, ...]
    reading: tuple[Setting, ...]
    """Those that say how recordings are read, which several commands share."""


def walked(group: Any, name: str) -> Iterator[tuple[str, Any]]:
    """Every command below a group that does something, by the words that call it."""
    for key, listed in group.commands.items():
        one = listed.loaded() if isinstance(listed, LazyCommand) else listed
        if hasattr(one, "commands"):
            yield from walked(one, f"{name} {key}")
        else:
            yield f"{name} {key}", one


def commands(group: Any, name: str) -> Iterator[Command]:
    """The same as the page shows them."""
    for words, one in walked(group, name):
        summary = (one.help or "").split("\n\n")[0].replace("\n", " ")
        yield Command(words, summary, tuple(_settings(one, False)), tuple(_settings(one, True)))


def _settings(command: Any, of_reading: bool) -> Iterator[Setting]:
    for one in command.params:
        if getattr(one, "hidden", False) or one.name == "help":
            continue
        if (getattr(one, "rich_help_panel", None) in (PANEL, TABLES)) != of_reading:
            continue
        if one.param_type_name == "argument":
            name = (one.metavar or one.name).upper()
        else:
            value = (
                ""
                if one.is_flag
                else f" {one.metavar or VALUES.get(one.type_descriptor.annotation, 'VALUE')}"
            )
            name = ", ".join([*one.opts, *one.secondary_opts]) + value
        shown = "" if one.default in (None, False, ()) or callable(one.default) else f"`{one.default}`"
        yield Setting(name, shown, " ".join((getattr(one, "help", "") or "").split()))


def command_page() -> dict[str, Any]:
    """Every command with its arguments and options."""
    every = list(commands(typer.main.get_command(app), "pointpred"))
    return {
        "commands": every,
        "reading": max((one.reading for one in every), key=len),
        "exits": {"done": DONE, "nothing": NOTHING, "wrong_use": WRONG_USE, "interrupted": INTERRUPTED},
    }


class Kind(msgspec.Struct, frozen=True):
    """An exception class."""

    name: str
    code: str
    builtin: str
    meaning: str


def kinds() -> Iterator[Kind]:
    """Every exception of the library, in the order of its file."""
    for one in vars(errors).values():
        if inspect.isclass(one) and issubclass(one, PointpredError):
            builtin = next(base.__name__ for base in one.__mro__ if base.__module__ == "builtins")
            meaning = inspect.getdoc(one) or ""
            yield Kind(one.__name__, one.code, builtin, meaning.split("\n\n")[0].replace("\n", " "))


def error_page() -> dict[str, Any]:
    """Errors of the library, codes of the service."""
    return {"kinds": list(kinds()), "codes": CODES, "closes": CLOSES}


class MetricRow(msgspec.Struct, frozen=True):
    """A metric as the table shows it."""

    name: str
    kind: str
    labels: str
    unit: str
    meaning: str


def metric_rows(registry: CollectorRegistry) -> Iterator[MetricRow]:
    """The metrics of a registry in their order."""
    for collector in registry._collector_to_names:
        labels = getattr(collector, "_labelnames", ())
        for family in collector.collect():
            yield _metric_row(family, labels or _labels(family))


def _metric_row(family: Metric, labels: tuple[str, ...]) -> MetricRow:
    unit = next((unit for end, unit in UNITS.items() if family.name.endswith(end)), "number")
    return MetricRow(
        family.name + ("_total" if family.type == "counter" else ""),
        family.type,
        ", ".join(f"`{label}`" for label in labels),
        unit,
        family.documentation.rstrip("."),
    )


def _labels(family: Metric) -> tuple[str, ...]:
    """The labels of a family that a collector makes anew each time, but for that of a histogram's buckets."""
    return tuple(
        dict.fromkeys(label for sample in family.samples for label in sample.labels if label != "le")
    )


def monitoring_page() -> dict[str, Any]:
    """Every metric and every log field of the service."""
    metrics = metric_rows(Metrics(1).registry)
    return {
        "metrics": sorted(metrics, key=lambda row: row.name.startswith(OF_PROCESS)),
        "every_entry": EVERY_ENTRY,
        "some_entries": FIELDS,
    }


def gains_of(name: str) -> dict[str, float]:
    """The parameters of the differentiator that ``build(name)`` takes from the registry."""
    stage = DIFFERENTIATORS[REGISTRY[name].differentiator]
    chosen = GAINS | REGISTRY[name].preset
    return {p.name: values_of(name)[p.name][1] for p in stage.parameters if p.name in chosen}


def predictor(name: str) -> dict[str, Any]:
    """One name of the registry: its own parameters, its differentiator, and whose parameters it shares.

    ``like``: the first name of the same class, where that is another one; ``differs``: the defaults that
    are not those of that one.
    """
    one, of_class = describe(name), REGISTRY[name].predictor
    own = [p for p in one["parameters"] if p["of"] == "predictor"]
    like = next(other for other in REGISTRY if REGISTRY[other].predictor is of_class)
    usual = {p["name"]: p["default"] for p in describe(like)["parameters"]}
    return {
        **one,
        "own": own,
        "gains": gains_of(name),
        "like": like if like != name else None,
        "differs": {p["name"]: p["default"] for p in own if p["default"] != usual[p["name"]]},
    }


class DifferentiatorEntry(msgspec.Struct, frozen=True):
    """One differentiator with the defaults of its class, but for the parameters that all have."""

    name: str
    title: str
    own: tuple[Parameter, ...]


def shared_parameters() -> list[Parameter]:
    """The parameters that every differentiator has."""
    first, *others = (stage.parameters for stage in DIFFERENTIATORS.values())
    return [one for one in first if all(one in parameters for parameters in others)]


def differentiator(name: str) -> DifferentiatorEntry:
    """The entry of one name."""
    stage = DIFFERENTIATORS[name]
    title = (stage.__doc__ or "").strip().splitlines()[0]
    return DifferentiatorEntry(
        name, title, tuple(one for one in stage.parameters if one not in shared_parameters())
    )


def streaming_us() -> dict[str, float]:
    """Microseconds of an event in a live session, by name."""
    cost = data.stored("costs", "events").tables["cost"]
    at = cost.columns.index("streaming, ns")
    return {str(row[0]).strip("`"): float(row[at]) / 1000 for row in cost.rows}


def predictor_page() -> dict[str, Any]:
    """The registry, and which predictor to take."""
    together = overall(stored())
    return {
        "recommended": RECOMMENDED,
        "floor": FLOOR,
        "shares": together.shares,
        "wins": dict(together.wins),
        "recorded": together.recorded,
        "costs": streaming_us(),
        "predictors": [predictor(name) for name in REGISTRY],
        "differentiators": [differentiator(name) for name in DIFFERENTIATORS],
        "common": shared_parameters(),
    }


def setting_page() -> dict[str, Any]:
    """Every setting of the service."""
    return {
        "settings": [
            {
                "name": name,
                "flag": name in FLAGS,
                "default": "-" if field.default is None or field.default == () else f"`{field.default}`",
                "meaning": field.description or "",
            }
            for name, field in Settings.model_fields.items()
        ]
    }


def readme_scores() -> dict[str, Any]:
    """Five rows on recorded people, without the targets and with them, and what to know of these numbers."""
    errors, elsewhere = (
        [dict(zip(table.columns, row, strict=True)) for row in table.rows]
        for table in (data.stored("targets").tables[name] for name in ("errors", "none"))
    )
    everything = overall(stored())
    people = {str(row["set"]).partition(",")[0]: int(row["people"]) for row in errors}
    return {
        "rows": [
            (label, *([row[one] for row in errors if one in row] for one in (column, f"{column} + targets")))
            for column, label in IN_README.items()
        ],
        "sets": len(errors),
        "people": sum(people.values()),
        "movements": sum(int(row["movements"]) for row in errors),
        "recommended": RECOMMENDED,
        "overall": everything,
        "shares": everything.shares[RECOMMENDED],
        "without_memory": everything.ablated[RECOMMENDED],
        "elsewhere": max(row["a third"] for row in elsewhere if row["predictor"] == RECOMMENDED),
    }


def openapi_document() -> str:
    """The OpenAPI document that the service serves at ``/openapi.json``, as JSON."""
    return json.dumps(create_app().openapi(), indent=2, sort_keys=True, ensure_ascii=False) + "\n"
