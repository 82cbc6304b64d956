"""Metrics of several processes as one text: sums where they make sense, else a figure for each process.

The counts of a process that has ended are kept: a sum does not fall when a worker is restarted.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import msgspec
from prometheus_client import CollectorRegistry, Metric, generate_latest
from prometheus_client.samples import Sample

OF_PROCESS = ("process_", "python_")
"""Metrics of one process, such as memory and open files: their sum says little, and would fall."""
ADDED_UP = ("counter", "histogram", "summary")
CREATED = "_created"

Row = tuple[str, dict[str, str], float]
"""Name, labels, value."""


class Family(msgspec.Struct, frozen=True, array_like=True):
    """A metric with its samples, as one process has it."""

    name: str
    documentation: str
    type: str
    rows: list[Row]


def families_of(registry: CollectorRegistry) -> list[Family]:
    """Every metric of a registry."""
    return [
        Family(
            metric.name,
            metric.documentation,
            metric.type,
            [(sample.name, sample.labels, sample.value) for sample in metric.samples],
        )
        for metric in registry.collect()
    ]


class ServiceFamilies:
    """The metrics of all workers: the newest of each, and what ended ones had counted."""

    def __init__(self) -> None:
        self._newest: dict[str, list[Family]] = {}
        self._ended: list[Family] = []

    def update(self, worker: str, families: list[Family]) -> None:
        """The newest metrics of a worker."""
        self._newest[worker] = families

    def end(self, worker: str) -> None:
        """A worker has ended: its counts stay, its gauges go."""
        counted = [
            family
            for family in self._newest.pop(worker, [])
            if family.type in ADDED_UP and not family.name.startswith(OF_PROCESS)
        ]
        self._ended = list(added(self._ended + counted))

    def merged(self) -> list[Family]:
        """The metrics of the service."""
        summed = list(self._ended)
        single: list[Family] = []
        for worker, families in self._newest.items():
            for family in families:
                if family.name.startswith(OF_PROCESS):
                    single.append(_labelled(family, worker))
                else:
                    summed.append(family)
        return [*added(summed), *_joined(single)]


def added(families: Iterable[Family]) -> Iterator[Family]:
    """Families of one name as one, whose samples of equal labels are added; the earliest time of creation.

    >>> counter = Family("a", "", "counter", [("a_total", {}, 2.0)])
    >>> [family.rows for family in added([counter, counter])]
    [[('a_total', {}, 4.0)]]
    """
    for family in _joined(families):
        values: dict[tuple[str, tuple[tuple[str, str], ...]], float] = {}
        for name, labels, value in family.rows:
            key = name, tuple(labels.items())
            if key not in values:
                values[key] = value
            else:
                values[key] = min(values[key], value) if name.endswith(CREATED) else values[key] + value
        rows = [(name, dict(labels), value) for (name, labels), value in values.items()]
        yield msgspec.structs.replace(family, rows=rows)


def text_of(families: Iterable[Family]) -> str:
    """The exposition format."""
    registry = CollectorRegistry()
    registry.register(_Given(families))
    return generate_latest(registry).decode()


class _Given:
    """A collector of families from elsewhere."""

    def __init__(self, families: Iterable[Family]) -> None:
        self._families = list(families)

    def collect(self) -> Iterator[Metric]:
        for family in self._families:
            metric = Metric(family.name, family.documentation, family.type)
            metric.samples = [Sample(*row) for row in family.rows]
            yield metric


def _joined(families: Iterable[Family]) -> list[Family]:
    """Families of one name as one, with the samples of all."""
    by_name: dict[str, Family] = {}
    for family in families:
        earlier = by_name.get(family.name)
        rows = family.rows if earlier is None else earlier.rows + family.rows
        by_name[family.name] = msgspec.structs.replace(family, rows=rows)
    return list(by_name.values())


def _labelled(family: Family, worker: str) -> Family:
    rows = [(name, {**labels, "worker": worker}, value) for name, labels, value in family.rows]
    return msgspec.structs.replace(family, rows=rows)
