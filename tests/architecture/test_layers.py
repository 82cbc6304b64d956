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
    "columns": {"errors", "regions", "events", "rows"},
    "drawing": {"files", "columns"},
    "mixtures": {"errors", "compiled", "regions", "columns"},
    "recording": {"errors", "events", "columns"},
    "parameter": {"errors"},
    "scene": {"errors", "events"},
    "stage": {"errors", "compiled", "events", "columns", "parameter"},
    "person": {"errors", "columns", "stage"},
    "regression": GROUND,
    "differentiators": GROUND | {"regression"},
    "transfer": GROUND | {"regression"},
    "observers": MATHS | {"drawing"},
    "camera": MATHS | {"observers"},
    "predictors": MATHS,
    "joint": {"compiled", "columns", "rows"},
    "pipeline": MATHS | {"predictors", "joint"},
    "registry": MATHS | {"predictors", "pipeline"},
    "simulation": PIPELINE,
    "targets": GROUND,
    "scoring": PIPELINE | {"targets"},
    "reproduction": PIPELINE | {"drawing", "observers", "camera", "simulation", "scoring", "sources"},
    "hid": {"errors"},
    "sources": {
        *("errors", "extras", "files", "events", "rows", "columns", "recording"),
        "hid",
    },
    "devices": MATHS | {"hid", "sources"},
    "console": set(),
    "datasets": PIPELINE | {"simulation", "sources"},
    "training": PIPELINE | {"scoring", "sources", "pointpred"},
    "protocol": PIPELINE | {"targets", "scoring"},
    "server": PIPELINE | {"protocol", "targets", "simulation", "scoring", "sources", "datasets", "pointpred"},
    "client": {"errors", "events", "rows", "columns", "registry", "protocol"},
    "live": PIPELINE | {"console", "devices", "sources", "scoring", "protocol", "client", "server"},
    "cli": PIPELINE
    | {
        "targets",
        "simulation",
        "scoring",
        "reproduction",
        "sources",
        "training",
        "datasets",
        "devices",
        "observers",
        "camera",
        "drawing",
        "protocol",
        "server",
        "client",
        "console",
        "live",
        "pointpred",
    },
    "pointpred": {"columns", "events", "pipeline", "regions", "registry"},
    "__main__": {"cli"},
}
"""What each layer may import beside itself; ``pointpred`` is the package's own ``__init__``."""

ROOMS_MAY_IMPORT = {
    "scoring.chunks": {"sources", "pointpred"},
    "scoring.report": {"drawing"},
}
"""What a room of a layer may import beyond its layer: the rest of ``scoring`` is pure computation."""

FILES = package_files()


def layer_of(module: str) -> str:
    parts = module.split(".")
    return parts[1] if len(parts) > 1 else "pointpred"


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


@pytest.mark.parametrize("layer", ["devices", "observers", "scoring", "server", "sources"])
def test_rooms_of_a_layer_have_an_order(layer: str) -> None:
    """What holds between layers holds between the rooms of a large one, too; its door stands apart."""
    graph: dict[str, set[str]] = {}
    for path in FILES:
        parts = module_of(path).split(".")
        if parts[1:2] == [layer] and len(parts) > 2:
            reached = {
                name.split(".")[2] for name in imports_of(path) if name.startswith(f"pointpred.{layer}.")
            }
            graph.setdefault(parts[2], set()).update(reached - {parts[2]})
    assert list(TopologicalSorter(graph).static_order())


def test_the_page_tells_of_every_room() -> None:
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    rooms = {path.parent.name for path in FILES} - {"pointpred"}
    assert [room for room in sorted(rooms) if f"  {room}/ " not in page and f"\n{room}/ " not in page] == []
    order = page[page.index("From the bottom up") : page.index("## The contract")]
    assert [
        layer for layer in MAY_IMPORT if layer not in order and layer not in ("pointpred", "__main__")
    ] == []
