"""The modules of the page: each import names what exists, imports go one way, and no export is dead."""

from __future__ import annotations

import posixpath
import re

from tests.architecture.tree import ROOT

WEB = ROOT / "server" / "pointpred_server" / "web"
PACKAGE = (
    *("laws", "human", "prediction", "client", "pointpred.js", "intent", "entries", "frameworks", "index.js"),
    "script",
)
PAGE = (
    *(
        "vendor",
        "shell",
        "drawing",
        "service",
        "study",
        "live",
        "circle",
        "replay",
        "assist",
        "device",
        "page.js",
    ),
    "example.js",
)
ORDER = (*(f"lib/{room}" for room in PACKAGE), *(f"page/{room}" for room in PAGE))
"""The folders, and the modules beside them, from the bottom up."""
IMPORT = re.compile(r'^(?:import|export) ([^;"]*?) from "([^"]+)"', re.MULTILINE)
LATER = re.compile(
    r'\{ ([^}]+) \} = await import\("[^"]+"\)|await import\("[^"]+"\)\)\.(\w+)'
    r'|import\("[^"]+"\)\.then\(\s*\(\{ ([^}]+) \}\)'
)
"""An import that waits until it is needed."""
EXPORT = re.compile(r"^export (?:async )?(?:function\*?|class|const|let) (\w+)", re.MULTILINE)
PUBLIC = {
    *("Connection", "connect", "regionOf", "build"),
    *("onIntent", "onPlace", "register", "prefetchLink", "ledger", "onLedger", "showOverlay"),
    *("useIntent", "useIntentState", "Intent", "vIntent", "intent", "linksOf", "human"),
}


def modules() -> dict[str, str]:
    """The text of each module, by its path."""
    found = (path for path in WEB.rglob("*.js") if path.parent.name != "vendor")
    return {path.relative_to(WEB).as_posix(): path.read_text(encoding="utf-8") for path in found}


def exports(text: str) -> set[str]:
    names = set(EXPORT.findall(text))
    for listed in re.findall(r"^export \{([^}]*)\}", text, re.MULTILINE):
        names |= {name.strip() for name in listed.split(",")}
    return names


def imports() -> list[tuple[str, str, set[str]]]:
    """Every import: the module, the one it imports from, and the names."""
    found = []
    for path, text in modules().items():
        for names, address in IMPORT.findall(text):
            if address[0] not in "./":
                continue  # of a framework, which the page brings
            beside = posixpath.join(posixpath.dirname(path), address)
            target = address.removeprefix("/").removeprefix("web/") if address[0] == "/" else beside
            listed = re.sub(r" as \w+", "", names.strip("{} \n,")).split(",") if "{" in names else []
            found.append((path, posixpath.normpath(target), {name.strip() for name in listed}))
    return found


def test_imports_name_what_exists() -> None:
    texts = modules()
    for path, target, names in imports():
        assert (WEB / target).is_file(), f"{path} imports {target}"
        assert not target.startswith("page/vendor/") or not names
        if target in texts:
            assert names <= exports(texts[target]), f"{path} imports {names} from {target}"


def test_imports_go_one_way() -> None:
    for path, target, _ in imports():
        room, below = (ORDER.index("/".join(one.split("/")[:2])) for one in (path, target))
        assert below <= room, f"{path} imports {target}"


def test_every_export_is_used() -> None:
    used = {name for _, _, names in imports() for name in names} | PUBLIC
    later = [found for text in modules().values() for found in LATER.findall(text)]
    used |= {name.strip() for found in later for name in "".join(found).split(",")}
    tests = "".join(
        path.read_text(encoding="utf-8")
        for room in ("server", "page")
        for path in (ROOT / "tests" / room).glob("*.*")
    )
    whole = {target for _, target, names in imports() if not names}  # as a namespace
    dead = {
        f"{path}: {name}"
        for path, text in modules().items()
        for name in exports(text) - used
        if not path.startswith("lib/laws/") and path not in whole and not re.search(rf"\b{name}\b", tests)
    }
    assert not dead
