"""What the page's own code uses of the laws: read from its imports."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from pathlib import Path

from translation.source import Name

WEB = Path(__file__).resolve().parent.parent / "server" / "pointpred_server" / "web"
LAWS = "lib/laws/"
OTHERS = ("lib/laws/", "lib/entries/", "page/vendor/")
"""Folders of modules that are not the page's own."""
HAND_WRITTEN = ("arithmetic.js", "coefficients.js")
"""Files beside the translator that go into the folder of laws as they are."""
NAMED = re.compile(r'^(?:import|export) \{([^}]*)\} from "([^"]+)"', re.MULTILINE)
WHOLE = re.compile(r'^import \* as (\w+) from "([^"]+)"', re.MULTILINE)


def roots() -> set[Name]:
    """The laws and constants that the page's own modules import."""
    wanted: set[Name] = set()
    for path in WEB.rglob("*.js"):
        name = path.relative_to(WEB).as_posix()
        if not name.startswith(OTHERS):
            wanted |= set(_imports(posixpath.dirname(name), path.read_text("utf-8")))
    return wanted


def _imports(folder: str, text: str) -> Iterator[Name]:
    """What a module in a folder imports of the laws."""
    for names, address in NAMED.findall(text):
        for word in (one.split(" as ")[0].strip() for one in names.split(",")):
            if (module := _module(folder, address)) and word:
                yield Name(module, _plain(word))
    for alias, address in WHOLE.findall(text):
        if module := _module(folder, address):
            code = re.sub(r'"[^"\n]*"', "", text)
            yield from (Name(module, _plain(word)) for word in set(re.findall(rf"\b{alias}\.(\w+)", code)))


def _module(folder: str, address: str) -> str:
    """The Python module of an address; empty for one that is not made of laws."""
    path = posixpath.normpath(posixpath.join(folder, address))
    file = path.removeprefix(LAWS)
    made = (
        path.startswith(LAWS)
        and not file.startswith("only/")
        and file
        not in (
            *HAND_WRITTEN,
            "kinematic.js",
            "registry.js",
            "messages.js",
            "fields.js",
        )
    )
    return f"pointpred.{file.removesuffix('.js').replace('/', '.')}" if made else ""


def _plain(word: str) -> str:
    """A name as Python has it."""
    return word.removesuffix("_")
