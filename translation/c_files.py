"""The files of C: a header, a file a room of the package, and the module that Python calls."""

from __future__ import annotations

import hashlib
import importlib
import inspect
from pathlib import Path
from typing import Any

import numpy as np

from pointpred.differentiators import Differentiator
from pointpred.layout import Layout
from pointpred.pipeline import joint_of, last_of
from pointpred.predictors import Predictor
from pointpred.stage import CompiledStage
from translation.c_law import Function, holds_arrays
from translation.c_module import module_text
from translation.c_names import Law, Made, c_name, source_of
from translation.c_values import literal
from translation.kinds import Memory, Number, Parts, in_c, kind_of_value, local
from translation.source import PLAIN, Name, is_law, module

WRITTEN = "/* Written by `make laws` from the laws: change those and run it again. */"


def write(package: str, folder: Path) -> None:
    """Write the files of a package's laws; those that are there and not written are removed."""
    files = texts(package)
    folder.mkdir(exist_ok=True)
    for path in folder.iterdir():
        if path.name not in files:
            path.unlink()
    for name, text in files.items():
        path = folder / name
        if not path.exists() or path.read_text("utf-8") != text:  # what is not changed is not compiled again
            path.write_text(text, "utf-8")


def texts(package: str) -> dict[str, str]:
    """The files by their names; raises UntranslatableError."""
    known: dict[Law, Function] = {}

    def read(law: Law) -> Function:
        if law not in known:
            known[law] = Function(law, *source_of(law), read)
        return known[law]

    for law in [*laws_in(package), *closures(package)]:
        read(law)
    entries = [
        one
        for law, one in known.items()
        if (law.module.partition(".")[0] == package or isinstance(law, Made))
        and not holds_arrays(one.returns)
    ]
    rooms: dict[str, list[Function]] = {}
    for one in known.values():
        rooms.setdefault(room_of(one.law), []).append(one)
    here = Path(__file__).parent
    shared = in_header(list(known.values()))
    files = {
        "abi3.h": (here / "abi3.h").read_text("utf-8"),
        "laws.h": header((here / "c_prelude.h").read_text("utf-8"), list(known.values()), shared),
        "module.c": module_text(
            sorted(entries, key=lambda one: c_name(one.law)), (here / "module.h").read_text("utf-8")
        ),
    }
    files |= {f"{room}.c": room_text(rooms[room], shared) for room in sorted(rooms)}
    digest = hashlib.sha256("".join(files[name] for name in sorted(files)).encode()).hexdigest()
    # Apart from the module, which takes the longest to compile.
    files["digest.c"] = (
        f'{WRITTEN}\nextern const char digest_of_laws[];\nconst char digest_of_laws[] = "{digest}";\n'
    )
    return files


def laws_in(package: str) -> list[Law]:
    """Every law of a package's modules."""
    found: list[Law] = []
    for name in modules_of(package):
        if name not in PLAIN:
            found += [Name(name, word) for word in module(name).laws]
    return found


def modules_of(package: str) -> list[str]:
    """The modules of a package that have laws."""
    home = Path(str(importlib.import_module(package).__file__)).parent
    files = [path for path in sorted(home.rglob("*.py")) if "\n@law\n" in path.read_text("utf-8")]
    return [".".join([package, *path.relative_to(home).with_suffix("").parts]) for path in files]


def closures(package: str) -> list[Law]:
    """The loops of all stages, and for every pair of a differentiator and a predictor its joint laws."""
    stages = [one for one in subclasses(CompiledStage) if one.__module__.partition(".")[0] == package]
    made = [made_of(one.loop) for one in stages if hasattr(one, "loop") and hasattr(one, "step")]
    for predictor in (one for one in stages if issubclass(one, Predictor) and hasattr(one, "step")):
        for first in (one for one in stages if issubclass(one, Differentiator) and hasattr(one, "step")):
            made.append(made_of(joint_of(first.step, predictor.step)))
            made.append(made_of(last_of(first.step, predictor.step, predictor.follow)))
    return list(dict.fromkeys(made))


def subclasses(of: type[Any]) -> list[type[Any]]:
    """All children of a class, and theirs."""
    return [one for child in of.__subclasses__() for one in (child, *subclasses(child))]


def made_of(function: Any) -> Law:
    """The law that a function is: by its name, or by what it closes over."""
    function = inspect.unwrap(function)
    if function.__closure__ is None:
        return Name(function.__module__, function.__name__)
    outer = function.__qualname__.partition(".<locals>")[0]
    cells = zip(function.__code__.co_freevars, function.__closure__, strict=True)
    return Made(
        function.__module__,
        outer,
        function.__name__,
        tuple((name, made_of(one.cell_contents)) for name, one in cells),
    )


def room_of(law: Law) -> str:
    """The room of a law: the packages that its module lies in."""
    if isinstance(law, Made):
        return room_of(dict(law.bound).get("second") or dict(law.bound).get("step") or law.bound[-1][1])
    words = law.module.split(".")[1:-1]
    return "_".join(words) or law.module.rpartition(".")[2]


def in_header(functions: list[Function]) -> list[Function]:
    """Short laws that other rooms call: in the header, a compiler can put them where they are called."""
    outside = {use for one in functions for use in one.uses if room_of(use) != room_of(one.law)}
    return [one for one in functions if one.law in outside and isinstance(one.law, Name) and one.is_short]


def header(prelude: str, functions: list[Function], shared: list[Function]) -> str:
    """The arrays and tuples, the heads of all laws, and the laws that rooms share."""
    structs: dict[str, Parts] = {}
    casts: dict[tuple[str, str], tuple[Parts, Parts]] = {}
    for one in functions:
        for kind in one.structs.values():
            _declare(kind, structs)
        for source, target in one.casts:
            casts[source.c, target.c] = source, target
    lines = [WRITTEN, "#ifndef POINTPRED_LAWS", "#define POINTPRED_LAWS", prelude.rstrip(), ""]
    for kind in structs.values():
        fields = " ".join(f"{inner.c} {kind.field(i)};" for i, inner in enumerate(kind.kinds))
        lines.append(f"typedef struct {{ {fields} }} {kind.c};")
    layouts: list[type[Layout]] = []
    for one in functions:
        for layout in sorted(one.layouts, key=lambda one: one.__module__ + one.__name__):
            _lay_out(layout, layouts)
    lines += [struct_text(layout) for layout in layouts]
    for source, target in sorted(casts.values(), key=lambda pair: (_depth(pair[0]), pair[0].c, pair[1].c)):
        parts = []
        for i, (inner, other) in enumerate(zip(source.kinds, target.kinds, strict=True)):
            part = f"value.{source.field(i)}"
            same = inner.c == other.c or isinstance(inner, Number)
            parts.append(part if same else f"{other.c}_of_{inner.c}({part})")
        lines.append(
            f"static inline {target.c} {target.c}_of_{source.c}({source.c} value) "
            f"{{ return ({target.c}){{{', '.join(parts)}}}; }}"
        )
    for one in sorted(functions, key=lambda one: c_name(one.law)):
        lines.append(f"static inline {one.head};" if one in shared else f"{one.head};")
    lines += [constant(one) for one in sorted(constants_of(shared))]
    for one in shared:
        lines += ["", one.comment + "static inline " + one.body]
    return "\n".join([*lines, "#endif", ""])


def _lay_out(layout: type[Layout], layouts: list[type[Layout]]) -> None:
    """Put a layout, and before it those that it is made of, into a list."""
    for part in layout.parts:
        if part.of is not None:
            _lay_out(part.of, layouts)
    if layout not in layouts:
        layouts.append(layout)


def struct_text(layout: type[Layout]) -> str:
    """The struct of a layout: nothing but numbers, one behind the other."""
    lines = []
    for part in layout.parts:
        kind = "double" if part.of is None else Memory(part.of).struct
        sizes = "".join("[]" if one == -1 else f"[{one}]" for one in part.shape)
        lines.append(f"  {kind} {local(part.name)}{sizes};")
    return "\n".join(["typedef struct {", *lines, f"}} {Memory(layout).struct};"])


def _declare(kind: Parts, structs: dict[str, Parts]) -> None:
    for one in kind.kinds:
        if isinstance(one, Parts):
            _declare(one, structs)
    structs.setdefault(kind.c, kind)


def _depth(kind: Parts) -> int:
    return 1 + max((_depth(one) for one in kind.kinds if isinstance(one, Parts)), default=0)


def constants_of(functions: list[Function]) -> set[Name]:
    """The constants that laws use."""
    return {use for one in functions for use in one.uses if isinstance(use, Name) and not is_law(use)}


def room_text(functions: list[Function], shared: list[Function]) -> str:
    """A room: its constants, its laws."""
    own = [one for one in functions if one not in shared]
    lines = [WRITTEN, '#include "laws.h"', ""]
    lines += [constant(one) for one in sorted(constants_of(own) - constants_of(shared))]
    for one in own:
        lines += ["", one.comment + ("WIDE " if one.is_wide else "") + one.body]
    return "\n".join([*lines, ""])


def constant(name: Name) -> str:
    """The declaration of a constant."""
    value = module(name.module).values[name.name]
    kind = kind_of_value(value)
    if isinstance(value, np.ndarray):
        return f"static const double {c_name(name)}[] = {literal(tuple(value.ravel().tolist())).text};"
    assert kind is not None
    word = kind.c
    if isinstance(kind, Parts) and type(value) is not tuple:
        word = in_c(Name(type(value).__module__, type(value).__name__))
    return f"static const {word} {c_name(name)} = {literal(value).text};"
