"""Imports go one way. A room not named here is a mistake: decide first where it stands."""

from __future__ import annotations

from graphlib import TopologicalSorter
from pathlib import Path

import pytest

from tests.architecture.tree import ROOT, imports_of, module_of, package_files

GROUND = {
    "errors",
    "extras",
    "files",
    "compiled",
    "regions",
    "events",
    "rows",
    "accelerations",
    "columns",
    "mixtures",
    "recording",
    "parameter",
    "stage",
    "person",
    "scene",
}
MATHS = GROUND | {"regression", "differentiators", "transfer"}
PIPELINE = MATHS | {"predictors", "joint", "pipeline", "registry"}
MAY_IMPORT = {
    "errors": set(),
    "extras": {"errors"},
    "files": set(),
    "compiled": set(),
    "regions": {"errors"},
    "events": {"errors", "regions"},
    "rows": {"compiled", "events"},
    "accelerations": {"errors"},
    "columns": {"errors", "regions", "events", "rows", "accelerations"},
    "drawing": {"files", "columns"},
    "mixtures": {"errors", "compiled", "regions", "columns"},
    "executors": {"errors", "extras"},
    "recording": {"errors", "events", "accelerations", "columns"},
    "parameter": {"errors"},
    "scene": {"errors", "events"},
    "stage": {"errors", "compiled", "events", "columns", "parameter"},
    "person": {"errors", "columns", "stage"},
    "regression": GROUND,
    "differentiators": GROUND | {"regression"},
    "transfer": GROUND | {"regression"},
    "predictors": MATHS,
    "joint": {"compiled", "columns", "rows"},
    "pipeline": MATHS | {"predictors", "joint"},
    "registry": MATHS | {"predictors", "pipeline"},
    "simulation": PIPELINE,
    "targets": GROUND,
    "scoring": PIPELINE | {"targets"},
    "report": PIPELINE | {"drawing", "scoring"},
    "reproduction": PIPELINE | {"drawing", "simulation", "scoring", "report", "sources"},
    "hid": {"errors"},
    "sources": {
        *("errors", "extras", "files", "events", "rows", "accelerations", "columns", "recording"),
        "hid",
    },
    "devices": MATHS | {"hid", "sources"},
    "console": set(),
    "datasets": PIPELINE | {"simulation", "sources"},
    "batch": PIPELINE | {"executors", "scoring", "sources", "pointpred"},
    "training": PIPELINE | {"executors", "scoring", "sources", "pointpred"},
    "protocol": PIPELINE | {"targets", "scoring"},
    "server": PIPELINE | {"protocol", "targets", "simulation", "scoring", "sources", "datasets", "pointpred"},
    "client": {"errors", "events", "rows", "columns", "registry", "protocol"},
    "replaying": PIPELINE | {"scoring", "protocol", "client"},
    "live": PIPELINE | {"console", "devices", "sources", "protocol", "server", "replaying"},
    "cli": PIPELINE
    | {
        "targets",
        "simulation",
        "scoring",
        "report",
        "reproduction",
        "sources",
        "batch",
        "executors",
        "training",
        "datasets",
        "devices",
        "drawing",
        "protocol",
        "server",
        "client",
        "replaying",
        "console",
        "live",
        "pointpred",
    },
    "pointpred": {"columns", "events", "pipeline", "regions", "registry"},
    "__main__": {"cli"},
    "observers": {"extras"},
    "camera": {"extras"},
    "pointpred_observers": MATHS | {"drawing"},
    "pointpred_observers.camera": MATHS | {"pointpred_observers"},
    "pointpred_observers.reproduction": MATHS
    | {"drawing", "reproduction", "pointpred_observers", "pointpred_observers.camera"},
    "pointpred_observers.cli": MATHS
    | {"cli", "console", "drawing", "pointpred_observers", "pointpred_observers.camera"},
}
"""What each layer may import beside itself; ``pointpred`` is the package's own ``__init__``.

``observers`` and ``camera`` are the names of version 0.1, which load ``pointpred_observers`` when asked.
"""

FILES = package_files()


def layer_of(module: str) -> str:
    parts = module.split(".")
    if parts[0] == "pointpred_observers":
        room = ".".join(parts[:2])
        return room if room in MAY_IMPORT else parts[0]
    return parts[1] if len(parts) > 1 else "pointpred"


@pytest.mark.parametrize("path", FILES, ids=module_of)
def test_imports_only_what_its_layer_may(path: Path) -> None:
    layer = layer_of(module_of(path))
    assert layer in MAY_IMPORT, f"{layer} belongs to no known layer"
    reached = {layer_of(name) for name in imports_of(path)} - {layer}
    assert reached <= MAY_IMPORT[layer], f"{layer} may not import {sorted(reached - MAY_IMPORT[layer])}"


def test_layers_have_an_order() -> None:
    assert list(TopologicalSorter(MAY_IMPORT).static_order())


def test_modules_have_an_order() -> None:
    """No module imports itself by way of others: a package counts apart from what lies in it."""
    graph = {module_of(path): imports_of(path, everywhere=False) - {module_of(path)} for path in FILES}
    for module, reached in graph.items():
        deeper = {name for name in reached if any(n.startswith(f"{name}.") for n in reached)}
        graph[module] = reached - deeper
    assert list(TopologicalSorter(graph).static_order())


LARGE = (
    *("pointpred.devices", "pointpred.report", "pointpred.scoring", "pointpred.server", "pointpred.sources"),
    "pointpred_observers",
)


@pytest.mark.parametrize("package", LARGE)
def test_rooms_of_a_layer_have_an_order(package: str) -> None:
    """What holds between layers holds between the rooms of a large one, too; its door stands apart."""
    graph: dict[str, set[str]] = {}
    within = f"{package}."
    for path in FILES:
        if module_of(path).startswith(within):
            room, *reached = (
                name.removeprefix(within).split(".")[0]
                for name in (module_of(path), *imports_of(path))
                if name.startswith(within)
            )
            graph.setdefault(room, set()).update({*reached} - {room})
    assert list(TopologicalSorter(graph).static_order())


def test_the_page_tells_of_every_room() -> None:
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    rooms = {path.parent.name for path in FILES} - {"pointpred", "pointpred_observers"}
    assert [room for room in sorted(rooms) if f"  {room}/ " not in page and f"\n{room}/ " not in page] == []
    order = page[page.index("From the bottom up") : page.index("## The contract")]
    assert [
        layer for layer in MAY_IMPORT if layer not in order and layer not in ("pointpred", "__main__")
    ] == []
