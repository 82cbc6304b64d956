"""The size of the house by one way of counting, for this checkout or another, of the old layout or the new.

``python evidence/house/measure.py`` prints the lines of each room against its budget, files, functions, names
defined twice, private functions and modules that one place uses, and the four journeys of ``journeys.py``.
Only files that git knows are counted, links are not followed, and blank lines and docstrings are lines.
Only the journeys run the tree, with ``--python``, which must have all that it depends on.
"""

from __future__ import annotations

import argparse
import ast
import json
import os
import re
import subprocess
import sys
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple, TypeGuard

HERE = Path(__file__).parent
Function = ast.FunctionDef | ast.AsyncFunctionDef


class Room(NamedTuple):
    """A row of the table: its lines before, its budget, and which paths are its own in both layouts.

    Before is commit c67f7742: one package, with the rooms of the server and of the observers in it.
    """

    name: str
    before: int
    budget: int
    paths: str
    endings: tuple[str, ...] = (".py",)
    product: bool = True

    def has(self, path: str) -> bool:
        """Whether a file belongs here, unless a room before this one has it."""
        return path.endswith(self.endings) and re.match(self.paths, path) is not None


LEARNED = "differentiators|regression|predictors|targets|transfer|simulation"
SCORED = "scoring|batch|executors|report|reproduction|studies|training"
JOINED = "devices|hid|live|replaying|cli|protocol|client"
FIGURES = r"camera|interconnected|interlaced|model_checks|reversed_connection"
WATCHED = rf"observers/|pointpred/(observers/|camera/|cli/(observer|camera)|reproduction/({FIGURES})\.py)"
WRITTEN = r"server/(?!.*\b(laws|vendor|tests|node_modules)/)"
OBSERVERS = Room("observers with camera and reproduction", 19_872, 11_000, WATCHED)
ROOMS = (
    Room("tests", 66_170, 45_000, "(server/|observers/)?tests/", product=False),
    Room("evidence", 15_897, 8_000, "(observers/)?(pages|benchmarks|evidence)/", product=False),
    Room("hand-written JavaScript", 9_795, 10_000, WRITTEN, (".js", ".mjs"), product=False),
    OBSERVERS,
    Room("server", 8_780, 4_500, "server/|pointpred/recorder/"),
    Room(JOINED.replace("|", ", "), 10_415, 8_500, f"pointpred/({JOINED})/"),
    Room(SCORED.replace("|", ", "), 8_009, 7_500, f"pointpred/({SCORED})/"),
    Room("recordings, sources, datasets", 8_811, 5_500, "pointpred/(sources|recordings|datasets)/|datasets/"),
    Room(LEARNED.replace("|", ", "), 13_683, 10_500, f"pointpred/({LEARNED})/"),
    Room(
        "core, with translation",
        4_654,
        5_000,
        r"(?!pointpred/laws/)(pointpred/|translation/|setup\.py)",
        (".py", ".c", ".h"),
    ),
)
"""In the order in which a path is tried, which is the reverse of the table's."""
PACKAGES = (
    ("server/pointpred_server/", "pointpred_server."),
    ("observers/pointpred_observers/", "pointpred_observers."),
    ("server/", "pointpred_server."),
    ("datasets/", "pointpred.datasets."),
    ("", ""),
)
"""Where a package lies and what its modules' names begin with, in both layouts."""


def room_of(path: str) -> Room | None:
    """The room of a path, ``None`` for what is neither product, page, evidence nor test."""
    return next((room for room in ROOMS if room.has(path)), None)


def module_of(path: str) -> str:
    """The dotted name that a file is imported by."""
    folder, package = next(each for each in PACKAGES if path.startswith(each[0]))
    name = package + path.removeprefix(folder).removesuffix(".py").replace("/", ".")
    return name.removesuffix(".__init__")


def span(node: ast.stmt | ast.expr) -> range:
    """The lines of a node, counted from 1."""
    return range(node.lineno, (node.end_lineno or node.lineno) + 1)


def is_text(node: ast.AST) -> TypeGuard[ast.Expr]:
    """Whether a node is a string that stands alone: a docstring, or what is said below a constant."""
    return isinstance(node, ast.Expr) and isinstance(getattr(node.value, "value", None), str)


def signature(function: Function) -> set[int]:
    """The lines of its decorators, and those from ``def`` to the body."""
    head = range(function.lineno, max(function.lineno + 1, function.body[0].lineno))
    return {*head, *(line for decorator in function.decorator_list for line in span(decorator))}


class File:
    """A Python file of the product, read."""

    def __init__(self, path: str, text: str) -> None:
        self.path, self.module = path, module_of(path)
        self.is_package = path.endswith("__init__.py")
        self.lines = text.splitlines()
        self.tree = ast.parse(text)
        self.nodes = list(ast.walk(self.tree))
        self.functions = [node for node in self.nodes if isinstance(node, Function)]

    def kinds(self) -> Counter[str]:
        """How many lines are text, blank, import, signature and the rest, each line once."""
        text = {line for node in self.nodes if is_text(node) for line in span(node)}
        imports = {
            n for node in self.nodes if isinstance(node, ast.Import | ast.ImportFrom) for n in span(node)
        }
        signatures = set().union(*(signature(function) for function in self.functions))
        found: Counter[str] = Counter()
        for number, line in enumerate(self.lines, 1):
            if number in text or line.strip().startswith("#"):
                found["text"] += 1
            elif not line.strip():
                found["blank"] += 1
            elif number in imports:
                found["import"] += 1
            else:
                found["signature" if number in signatures else "rest"] += 1
        return found

    def lengths(self) -> list[int]:
        """The lines of each function without its docstring."""
        heads = ((function, function.body[0]) for function in self.functions)
        return [
            len(span(function)) - (len(span(first)) if is_text(first) else 0) for function, first in heads
        ]

    def defined(self) -> Iterator[tuple[str, str]]:
        """Kind and name of each class, function and constant of the module itself."""
        for node in self.tree.body:
            if isinstance(node, ast.ClassDef):
                yield "class", node.name
            elif isinstance(node, Function):
                yield "function", node.name
            elif isinstance(node, ast.Assign | ast.AnnAssign):
                targets = node.targets if isinstance(node, ast.Assign) else [node.target]
                yield from (("constant", target.id) for target in targets if isinstance(target, ast.Name))

    def private(self) -> list[int]:
        """How often the file names each of its functions with one leading underscore."""
        uses = Counter(node.attr for node in self.nodes if isinstance(node, ast.Attribute))
        uses.update(n.id for n in self.nodes if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Load))
        return [
            uses[f.name] for f in self.functions if f.name.startswith("_") and not f.name.startswith("__")
        ]


class House:
    """A checkout: the files that git knows, by room, and its product read."""

    def __init__(self, root: Path) -> None:
        self.root = root
        command = ["git", "ls-files", "-z"]
        listed = subprocess.run(command, cwd=root, capture_output=True, check=True, encoding="utf-8").stdout
        present = (path for path in listed.split("\0") if path and (root / path).is_file())
        self.rooms = {
            path: room for path in present if not (root / path).is_symlink() and (room := room_of(path))
        }
        own = [path for path, room in self.rooms.items() if room.product and path.endswith(".py")]
        self.product = [File(path, self._text(path)) for path in own]

    def _text(self, path: str) -> str:
        return (self.root / path).read_text(encoding="utf-8")

    def lines_by_room(self) -> list[dict[str, Any]]:
        """Files, lines, lines of before and budget of each room."""
        files, lines = Counter(self.rooms.values()), Counter[Room]()
        for path, room in self.rooms.items():
            lines[room] += len(self._text(path).splitlines())
        return [
            {"room": r.name, "files": files[r], "lines": lines[r], "before": r.before, "budget": r.budget}
            for r in reversed(ROOMS)
        ]

    def product_numbers(self) -> dict[str, float]:
        """What is counted of the product's Python, by what it is called in the table."""
        kinds = sum((file.kinds() for file in self.product), Counter[str]())
        lengths = [length for file in self.product for length in file.lengths()]
        private = [uses for file in self.product for uses in file.private()]
        installed = [file for file in self.product if file.module.startswith("pointpred")]
        modules = [file.module for file in installed if not file.is_package]
        importers = self._importers(installed)
        idle = kinds["import"] + kinds["signature"] + kinds["blank"]
        pointing = (len(file.lines) for file in self.product if self.rooms[file.path] is not OBSERVERS)
        return {
            "files": len(self.product),
            "lines": kinds.total(),
            "lines without observers": sum(pointing),
            "functions": len(lengths),
            "lines of a function, mean": round(sum(lengths) / len(lengths), 1),
            "imports, % of lines": round(100 * kinds["import"] / kinds.total(), 1),
            "imports, signatures and blank lines, %": round(100 * idle / kinds.total(), 1),
            "private functions": len(private),
            "private functions with one caller": private.count(1),
            "modules": len(modules),
            "modules with one importer": sum(importers[module] == 1 for module in modules),
        }

    def _importers(self, installed: list[File]) -> Counter[str]:
        """How many modules import each; a package that only passes a name on is looked through."""
        files = {file.module: file for file in installed}
        importing = (file for file in installed if not file.is_package)
        return Counter(module for file in importing for module in set(_imported(file, files)) - {file.module})

    def names_twice(self) -> dict[str, dict[str, list[str]]]:
        """By kind, the public names that two modules or more define, and which."""
        places: defaultdict[str, defaultdict[str, list[str]]] = defaultdict(lambda: defaultdict(list))
        for file in self.product:
            for kind, name in sorted(set(file.defined())):
                places[kind][name].append(file.module)
        return {
            kind: {n: sorted(where) for n, where in sorted(names.items()) if len(where) > 1 and n[0] != "_"}
            for kind, names in sorted(places.items())
        }

    def journeys(self, python: str) -> dict[str, dict[str, Any]]:
        """What ``journeys.py`` traces in this tree, in a process of its own."""
        roots = [str((self.root / folder).resolve()) for folder in ("", "server", "observers")]
        environment = os.environ | {"PYTHONPATH": os.pathsep.join(roots), "POINTPRED_COMPILED": "0"}
        command = [python, str(HERE / "journeys.py"), roots[0]]
        traced = subprocess.run(
            command, env=environment, stdout=subprocess.PIPE, check=True, encoding="utf-8"
        )
        journeys: dict[str, dict[str, Any]] = json.loads(traced.stdout)
        return journeys


def _imported(file: File, files: dict[str, File]) -> Iterator[str]:
    """The modules that a file imports anywhere in it, each name where it is defined."""
    for node in file.nodes:
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name in files)
        elif isinstance(node, ast.ImportFrom) and node.module in files:
            yield from (_home(node.module, alias.name, files) for alias in node.names)


def _home(module: str, name: str, files: dict[str, File]) -> str:
    """The module that ``from module import name`` reaches; a package itself where it does not say."""
    if f"{module}.{name}" in files:
        return f"{module}.{name}"
    imports = (node for node in files[module].nodes if isinstance(node, ast.ImportFrom))
    for node in imports if files[module].is_package else ():
        if node.module in files and name in {each.asname or each.name for each in node.names}:
            return _home(node.module, name, files)
    return module


def table(*rows: Iterable[object]) -> str:
    """Rows of Markdown below the first, which names the columns."""
    first, *others = ([f"{cell:,}" if isinstance(cell, int) else str(cell) for cell in row] for row in rows)
    lines = [first, ["---", *["---:"] * (len(first) - 1)], *others]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines) + "\n"


def main(arguments: list[str] | None = None) -> None:
    """Measure one checkout, print the tables, and write the numbers where they are asked for."""
    parser = argparse.ArgumentParser(description="Measure a checkout against the budgets of its rooms.")
    parser.add_argument("--at", type=Path, default=HERE.parents[1], metavar="FOLDER", help="another checkout")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the numbers here, too")
    parser.add_argument("--python", default=sys.executable, help="what runs the journeys")
    parser.add_argument("--no-journeys", action="store_true", help="count only, run nothing of the tree")
    chosen = parser.parse_args(arguments)
    house = House(chosen.at)
    rooms, product, twice = house.lines_by_room(), house.product_numbers(), house.names_twice()
    journeys = {} if chosen.no_journeys else house.journeys(chosen.python)
    print(table(rooms[0], *(room.values() for room in rooms)))
    names = ((f"names of a {kind} in two modules or more", len(names)) for kind, names in twice.items())
    print(table(("the product's Python", "number"), *product.items(), *names))
    if journeys:
        counted = ((name, each["functions"], each["files"]) for name, each in journeys.items())
        print(table(("journey", "functions", "files"), *counted))
    if chosen.json:
        numbers = {"rooms": rooms, "product": product, "names_twice": twice, "journeys": journeys}
        chosen.json.write_text(json.dumps(numbers, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
