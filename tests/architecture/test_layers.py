"""Imports go one way. A room not named here is a mistake: decide first where it stands."""

from __future__ import annotations

from graphlib import TopologicalSorter
from pathlib import Path

import pytest

from tests.architecture.tree import PACKAGES, ROOT, imports_of, module_of, package_files

GROUND = {
    "errors",
    "extras",
    "files",
    "logs",
    "garbage",
    "layout",
    "compiled",
    "regions",
    "columns",
    "records",
    "recording",
    "parameter",
    "stage",
    "person",
    "scene",
}
MATHS = GROUND | {"regression", "differentiators", "transfer"}
PIPELINE = MATHS | {"predictors", "targets", "pipeline", "registry"}
MAY_IMPORT = {
    "errors": set(),
    "extras": {"errors"},
    "files": set(),
    "logs": set(),
    "garbage": set(),
    "clock": set(),
    "layout": set(),
    "compiled": {"layout"},
    "regions": {"errors"},
    "columns": {"errors", "extras"},
    "records": {"errors", "columns", "compiled", "regions", "parameter"},
    "drawing": {"files", "records"},
    "recording": {"errors", "records"},
    "parameter": {"errors"},
    "scene": {"errors", "records"},
    "stage": {"errors", "layout", "compiled", "records", "parameter"},
    "person": {"errors", "layout", "records", "stage"},
    "regression": GROUND,
    "differentiators": GROUND | {"regression"},
    "transfer": GROUND | {"regression"},
    "predictors": MATHS,
    "targets": GROUND | {"predictors"},
    "pipeline": MATHS | {"predictors", "targets"},
    "registry": MATHS | {"predictors", "targets", "pipeline"},
    "simulation": PIPELINE,
    "scoring": PIPELINE,
    "measures": PIPELINE | {"drawing", "scoring"},
    "benchmark": PIPELINE | {"drawing", "scoring", "datasets"},
    "reproduction": PIPELINE | {"drawing", "simulation", "scoring", "recordings"},
    "devices.surface": set(),
    "devices.hid": {"errors", "devices.surface"},
    "recordings": {
        "errors",
        "extras",
        "files",
        "columns",
        "records",
        "recording",
        "devices.hid",
        "devices.surface",
    },
    "devices": MATHS | {"devices.hid", "devices.surface", "recordings"},
    "console": set(),
    "datasets": PIPELINE | {"simulation", "recordings"},
    "training": PIPELINE | {"scoring", "recordings", "pointpred"},
    "protocol": PIPELINE | {"clock", "scoring"},
    "recorder": GROUND | {"protocol", "recordings"},
    "studies": PIPELINE | {"clock", "simulation", "recordings", "protocol", "recorder", "devices", "live"},
    "client": {"errors", "extras", "records", "registry", "protocol"},
    "live": PIPELINE
    | {"clock", "console", "devices", "recordings", "scoring", "protocol", "client", "recorder"},
    "cli": PIPELINE
    | {
        "clock",
        "simulation",
        "scoring",
        "measures",
        "benchmark",
        "reproduction",
        "recordings",
        "training",
        "datasets",
        "devices",
        "drawing",
        "protocol",
        "recorder",
        "client",
        "console",
        "live",
        "plugins",
        "pointpred",
    },
    "plugins": PIPELINE,
    "pointpred": {"records", "pipeline", "regions", "registry"},
    "__main__": {"cli"},
    "observers": {"extras"},
    "camera": {"extras"},
    "pointpred_server": PIPELINE
    | {
        *("console", "protocol", "simulation", "scoring", "recordings", "datasets", "recorder"),
        *("studies", "devices"),
        *("clock", "live", "cli", "pointpred"),
    },
    "pointpred_observers": MATHS | {"drawing"},
    "pointpred_observers.camera": MATHS | {"pointpred_observers"},
    "pointpred_observers.reproduction": MATHS
    | {"drawing", "reproduction", "pointpred_observers", "pointpred_observers.camera"},
    "pointpred_observers.cli": MATHS
    | {"cli", "console", "drawing", "pointpred_observers", "pointpred_observers.camera"},
}
"""What each layer may import beside itself; ``pointpred`` is the library's own ``__init__``.

``devices.hid`` and ``devices.surface`` stand apart from ``devices``: recordings are read by them, too.

``observers`` and ``camera`` are the names of version 0.1, which load ``pointpred_observers`` when asked.
"""

ROOMS_MAY_IMPORT = {
    "scoring.chunks": {"recordings", "pointpred"},
    "scoring.report": {"drawing"},
}
"""What a room of a layer may import beyond its layer: the rest of ``scoring`` is pure computation."""

FILES = package_files()


def layer_of(module: str) -> str:
    package, *rooms = module.split(".")
    if package == "pointpred":
        room = ".".join(rooms[:2])
        return room if room in MAY_IMPORT else rooms[0] if rooms else package
    room = ".".join([package, *rooms[:1]])
    return room if room in MAY_IMPORT else package


@pytest.mark.parametrize("path", FILES, ids=module_of)
def test_imports_only_what_its_layer_may(path: Path) -> None:
    layer = layer_of(module_of(path))
    assert layer in MAY_IMPORT, f"{layer} belongs to no known layer"
    reached = {layer_of(name) for name in imports_of(path)} - {layer}
    room = ".".join(module_of(path).split(".")[1:3])
    allowed = MAY_IMPORT[layer] | ROOMS_MAY_IMPORT.get(room, set())
    assert reached <= allowed, f"{room} may not import {sorted(reached - allowed)}"


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
    *("pointpred.devices", "pointpred.scoring"),
    *("pointpred.recordings", "pointpred_server", "pointpred_observers"),
)


@pytest.mark.parametrize("layer", LARGE)
def test_rooms_of_a_layer_have_an_order(layer: str) -> None:
    """What holds between layers holds between the rooms of a large one, too; its door stands apart."""
    graph: dict[str, set[str]] = {}
    inside = f"{layer}."
    for path in FILES:
        module = module_of(path)
        if module.startswith(inside):
            room = module.removeprefix(inside).split(".")[0]
            reached = {
                name.removeprefix(inside).split(".")[0]
                for name in imports_of(path)
                if name.startswith(inside)
            }
            graph.setdefault(room, set()).update(reached - {room})
    assert list(TopologicalSorter(graph).static_order())


def test_the_page_tells_of_every_room() -> None:
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    rooms = {path.parent.name for path in FILES} - {*PACKAGES}
    assert [room for room in sorted(rooms) if f"  {room}/ " not in page] == []
    order = page[page.index("From the bottom up") : page.index("## The contract")]
    assert [
        layer for layer in MAY_IMPORT if layer not in order and layer not in ("pointpred", "__main__")
    ] == []
