"""Which systems get every library as a wheel: ``python -m evidence reference wheels`` queries the index.

What pointpred and its extras need there follows from the markers of the installed libraries, with versions of
constraints.txt. Nothing is installed; pip reports what it would install for Python 3.11.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import tomllib
from importlib.metadata import PackageNotFoundError, requires

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from evidence import ROOT
from evidence.arguments import parse

WINDOWS = {"sys_platform": "win32", "platform_system": "Windows", "os_name": "nt"}
MACOS = {"sys_platform": "darwin", "platform_system": "Darwin", "os_name": "posix"}
INTEL, ARM = {"platform_machine": "x86_64"}, {"platform_machine": "arm64"}
SYSTEMS = (
    ("Windows, x86-64", WINDOWS | {"platform_machine": "AMD64"}, ("win_amd64",)),
    ("macOS 11, arm64", MACOS | ARM, ("macosx_11_0_arm64",)),
    ("macOS 12, arm64", MACOS | ARM, ("macosx_11_0_arm64", "macosx_12_0_arm64")),
    ("macOS 14, arm64", MACOS | ARM, tuple(f"macosx_{n}_0_arm64" for n in (11, 12, 13, 14))),
    (
        "macOS 14, x86-64",
        MACOS | INTEL,
        tuple(f"macosx_{n}_x86_64" for n in ("10_9", "11_0", "12_0", "14_0")),
    ),
)
"""Name, what markers see, and the platforms of wheels that it takes."""


def main() -> None:
    about = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = {name: needs for name, needs in about["optional-dependencies"].items() if name != "dev"}
    lines = (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()
    pinned = {canonicalize_name(line.partition("=")[0]): line for line in lines if "==" in line}
    missing = 0
    for name, system, platforms in SYSTEMS:
        for what, start in {"": about["dependencies"], **extras}.items():
            needed = [pinned.get(one, one) for one in sorted(closure(start, system))]
            absent = (
                [] if there(needed, platforms) else [one for one in needed if not there([one], platforms)]
            )
            missing += bool(absent)
            text = f"no wheel of {', '.join(absent)}" if absent else f"{len(needed)} wheels"
            print(f"{name}: {f'extra {what}' if what else 'pointpred'}: {text}", flush=True)
    sys.exit(missing > 0)


def closure(start: list[str], system: dict[str, str]) -> set[str]:
    """The names of all libraries that requirements come to on a system, pointpred itself left out."""
    names: set[str] = set()
    visits: set[tuple[str, frozenset[str]]] = set()
    waiting = [(Requirement(line), "") for line in start]
    while waiting:
        need, extra = waiting.pop()
        name = canonicalize_name(need.name)
        if (need.marker and not need.marker.evaluate({**system, "extra": extra})) or name == "pointpred":
            continue
        names.add(name)
        if (name, frozenset(need.extras)) not in visits:
            visits.add((name, frozenset(need.extras)))
            for inner in ("", *need.extras):
                waiting += [(Requirement(line), inner) for line in requirements(name)]
    return names


def requirements(name: str) -> list[str]:
    """What an installed library requires; one that this system does not need is taken for a leaf."""
    try:
        return requires(name) or []
    except PackageNotFoundError:
        return []


def there(needed: list[str], platforms: tuple[str, ...]) -> bool:
    """Whether pip finds a wheel of each."""
    with tempfile.TemporaryDirectory() as folder:
        pip = [
            sys.executable,
            "-m",
            "pip",
            "install",
            "--quiet",
            "--dry-run",
            "--no-deps",
            "--target",
            folder,
        ]
        wheels = ["--only-binary=:all:", "--python-version=3.11", "--ignore-installed"]
        places = [f"--platform={platform}" for platform in platforms]
        return not subprocess.run([*pip, *wheels, *places, *needed], capture_output=True).returncode


if __name__ == "__main__":
    parse(__doc__)
    main()
