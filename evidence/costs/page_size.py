"""Size of what a page loads, by entry.

An entry is an export of the npm package and a predictor. Its modules are those that its imports reach,
without what is loaded later (the overlay, what the keyboard, a scroll and an image's map need, a service) and
without other predictors. Two sizes, compressed with gzip: the modules one by one, as a static host sends
the plain files; and, where npm can fetch esbuild, one minified file, as a bundler makes it.
"""

from __future__ import annotations

import gzip
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

from pointpred.registry import RECOMMENDED

LIB = Path(__file__).resolve().parents[2] / "server" / "pointpred_server" / "web" / "lib"
STATIC = re.compile(r'^(?:import|export)\b[^;"]*?from "(\.[^"]+)"', re.MULTILINE)
LATER = re.compile(r'import\("(\.[^"]+)"\)')
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
ON_DEMAND = (
    "intent/later.js",
    "intent/overlay/",
    "intent/service-source.js",
)
"""What a page loads when it is idle, or only when somebody asks for it."""
ESBUILD = "esbuild@0.25.12"


def reached(entry: str, predictor: str) -> list[Path]:
    """Every module that an entry needs with a predictor, its coefficients included."""
    chosen = set(_modules_of(predictor))
    waiting, found = [LIB / entry], set()
    while waiting:
        path = waiting.pop().resolve()
        if path in found:
            continue
        found.add(path)
        if path.suffix == ".js":
            waiting += [
                one for one in _imports(path) if _counts(one, path, chosen, bool(coefficients(predictor)))
            ]
    return sorted(found)


def _imports(path: Path) -> Iterator[Path]:
    text = COMMENT.sub("", path.read_text(encoding="utf-8"))
    for address in (*STATIC.findall(text), *LATER.findall(text)):
        yield (path.parent / address).resolve()


def _counts(path: Path, reader: Path, chosen: set[Path], kinematic: bool) -> bool:
    """Whether a module that another one imports is loaded; the registry names those of every predictor."""
    name = path.relative_to(LIB).as_posix()
    if reader.name == "places.js" and name in ("prediction/build.js", "prediction/chooser.js"):
        return False  # for proposals of places
    if reader.name == "source.js" and path.name == "build.js" and not kinematic:
        return False
    return not name.startswith(ON_DEMAND) and (reader.name != "registry.js" or path in chosen)


def _modules_of(predictor: str) -> Iterator[Path]:
    """The modules that the registry loads for a predictor."""
    laws = LIB / "laws"
    for line in (laws / "registry.js").read_text(encoding="utf-8").splitlines():
        named = re.match(r'  "([^"]+)": \{.*import\("(\.[^"]+)"\)', line)
        first = "minimum-jerk" if predictor == RECOMMENDED else predictor  # predicts until that is loaded
        if named and named[1] in (predictor, first, "homogeneous"):
            yield (laws / named[2]).resolve()


def compressed(files: list[Path]) -> int:
    """Bytes of the files, each compressed."""
    return sum(len(gzip.compress(path.read_bytes(), 9, mtime=0)) for path in files)


def coefficients(predictor: str) -> list[Path]:
    """The file of numbers that a predictor needs."""
    return [LIB / "laws" / "kinematic.f32"] if predictor.startswith("kinematic") else []


def bundled(entry: str, files: list[Path], folder: Path) -> int | None:
    """Bytes of one minified file; None without esbuild. Raises RuntimeError for what esbuild refuses."""
    if shutil.which("npm") is None:
        return None
    module = folder / "node_modules" / "esbuild" / "lib" / "main.js"
    if not module.exists():
        command = ["npm", "install", "--silent", "--no-audit", "--no-fund", "--prefix", str(folder), ESBUILD]
        if subprocess.run(command, capture_output=True).returncode:
            return None
    script = Path(__file__).with_name("page_bundle.mjs")
    command = ["node", str(script), str(module), str(LIB / entry), *map(str, files)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"esbuild cannot bundle {entry}: {done.stderr[-500:]}")
    return int(done.stdout)


def sizes(entry: str, predictor: str, folder: Path) -> tuple[int, int, int | None]:
    """How many files, their bytes, and those of one bundle with the numbers beside it."""
    files, numbers = reached(entry, predictor), coefficients(predictor)
    one = bundled(entry, files, folder)
    plain = compressed([*files, *numbers])
    return len(files) + len(numbers), plain, None if one is None else one + compressed(numbers)
