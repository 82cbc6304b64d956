"""What docs/reference/monitoring.md shows: every metric and every log field of the service, from the code."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import msgspec
from prometheus_client import CollectorRegistry, Metric

from pointpred_server.logs import EVERY_ENTRY, FIELDS
from pointpred_server.metrics import Metrics
from pointpred_server.workers.families import OF_PROCESS
from pointpred_server.workers.supervisor import SupervisorMetrics

UNITS = {"_seconds": "s", "_bytes": "bytes", "_info": ""}
"""By the end of a name; other metrics count."""


class Row(msgspec.Struct, frozen=True):
    """A metric as the table shows it."""

    name: str
    kind: str
    labels: str
    unit: str
    meaning: str


def rows(registry: CollectorRegistry) -> Iterator[Row]:
    """The metrics of a registry in their order."""
    for collector in registry._collector_to_names:
        labels = getattr(collector, "_labelnames", ())
        for family in collector.collect():
            yield _row(family, labels or _labels(family))


def _row(family: Metric, labels: tuple[str, ...]) -> Row:
    unit = next((unit for end, unit in UNITS.items() if family.name.endswith(end)), "number")
    return Row(
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


def context() -> dict[str, Any]:
    """What the template needs."""
    service = {row.name: row for row in rows(Metrics().registry)}
    supervisor = {row.name: row for row in rows(SupervisorMetrics().registry)}
    return {
        "service": sorted(service.values(), key=lambda row: row.name.startswith(OF_PROCESS)),
        "supervisor": [row for name, row in supervisor.items() if name not in service],
        "every_entry": EVERY_ENTRY,
        "some_entries": FIELDS,
    }
