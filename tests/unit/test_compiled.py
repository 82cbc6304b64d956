"""The cache of compiled laws notices what numba does not: a change in what a law reaches."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import FunctionType

import pytest

from pointpred import compiled

pytestmark = pytest.mark.skipif(not compiled.COMPILED, reason="POINTPRED_COMPILED=0: nothing is compiled")


def law_reading(constant: float, callee: object) -> str:
    """The fingerprint of one and the same source in a module with these globals."""

    def source(x: float) -> float:
        return CALLEE(x) + CONSTANT  # type: ignore[name-defined, no-any-return]  # noqa: F821

    scope = {"CONSTANT": constant, "CALLEE": callee, "__name__": "module"}
    return compiled._fingerprint(FunctionType(source.__code__, scope))


@compiled.law
def doubled(x: float) -> float:
    return 2.0 * x


@compiled.law
def tripled(x: float) -> float:
    return 3.0 * x


@compiled.layout
def quadrupled(x: float) -> float:
    return 4.0 * x


def test_the_same_law_has_the_same_fingerprint() -> None:
    assert law_reading(1.0, doubled) == law_reading(1.0, doubled)


def test_another_constant_or_another_callee_is_another_law() -> None:
    fingerprints = {law_reading(1.0, doubled), law_reading(2.0, doubled), law_reading(1.0, tripled)}
    fingerprints.add(law_reading(1.0, quadrupled))
    assert len(fingerprints) == 4


def test_a_layout_stays_plain_python_and_laws_may_call_it() -> None:
    @compiled.law
    def through(x: float) -> float:
        return quadrupled(x)

    assert isinstance(quadrupled, FunctionType)
    assert through(2.0) == 8.0


@pytest.fixture
def homeless(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[Path]:
    """No cache of the user's own; the temporary folder's place for it, which does not exist yet."""
    monkeypatch.delenv("POINTPRED_CACHE_DIR", raising=False)
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    compiled._cache_folder.cache_clear()
    yield tmp_path / f"pointpred-{os.getuid()}"
    compiled._cache_folder.cache_clear()


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="without user ids")
def test_the_cache_in_a_shared_folder_is_made_for_its_user_alone(homeless: Path) -> None:
    assert compiled._cache_folder() == homeless
    assert stat.S_IMODE(homeless.stat().st_mode) == 0o700
    compiled._cache_folder.cache_clear()
    assert compiled._cache_folder() == homeless  # and is used again


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="without user ids")
@pytest.mark.parametrize("trap", ["link", "open to all", "of someone else", "file"])
def test_a_cache_that_others_could_have_written_is_not_read(
    homeless: Path, trap: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    if trap == "link":
        homeless.symlink_to(homeless.parent, target_is_directory=True)
    elif trap == "file":
        homeless.write_text("")
    else:
        homeless.mkdir(mode=0o700)
    if trap == "open to all":
        homeless.chmod(0o777)
    if trap == "of someone else":
        mine = os.getuid()
        owner = f"pointpred-{mine + 1}"
        monkeypatch.setattr(os, "getuid", lambda: mine + 1)
        homeless.rename(homeless.with_name(owner))
    with pytest.warns(RuntimeWarning, match="compiles anew in every process.*POINTPRED_CACHE_DIR"):
        assert compiled._cache_folder() is None

    @compiled.law
    def halved(x: float) -> float:
        return 0.5 * x

    assert halved(3.0) == 1.5
    assert halved.stats.cache_path is None  # type: ignore[attr-defined]


SEALED = """
import os, sys
seen = {"read": 0, "written": 0}
from numba.core import caching
load = caching.IndexDataCacheFile.load
def counted(self, key):
    found = load(self, key)
    seen["read"] += found is not None
    return found
caching.IndexDataCacheFile.load = counted
caching.IndexDataCacheFile.save = lambda *_: seen.update(written=seen["written"] + 1)
if sys.argv[1] == "sealed":
    access = os.access
    os.access = lambda path, mode: mode == os.R_OK and access(path, mode)
    from tempfile import TemporaryFile
    def refused(*a, **k): raise PermissionError(13, "read-only")
    caching.tempfile.TemporaryFile = refused
from pointpred import build, PointerEvent
pipeline = build("linear")
for i in range(20):
    pipeline.update(PointerEvent(i / 100, float(i * i), 0.0))
print(seen["read"] > 0, seen["written"] > 0)
"""


def test_a_cache_that_is_only_read_is_used_and_not_written(tmp_path: Path) -> None:
    environment = {**os.environ, "POINTPRED_CACHE_DIR": str(tmp_path)}

    def told(*arguments: str) -> str:
        command = [sys.executable, "-c", *arguments]
        run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        return run.stdout.strip()

    warm = "from pointpred import build, PointerEvent\npipeline = build('linear')\n"
    warm += "for i in range(20): pipeline.update(PointerEvent(i / 100, float(i * i), 0.0))"
    told(warm)
    assert told(SEALED, "sealed") == "True False"
    assert told(SEALED, "open") == "True False"
    for path in sorted(tmp_path.rglob("*"), reverse=True):
        path.rmdir() if path.is_dir() else path.unlink()
    assert told(SEALED, "sealed") == "False False"
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("ending", [".nbi", ".nbc"])
@pytest.mark.parametrize("kept", [0, 7, 60])
def test_damaged_files_of_the_cache_are_compiled_anew(ending: str, kept: int, tmp_path: Path) -> None:
    """As a full disk leaves them; the second process finds them damaged, the third mended."""
    program = "from pointpred.compiled import law\n@law\ndef f(x):\n    return 2.0 * x\nprint(f(4.0))"
    (tmp_path / "program.py").write_text(program)
    environment = {**os.environ, "POINTPRED_CACHE_DIR": str(tmp_path / "cache")}

    def run() -> str:
        left = subprocess.run(
            [sys.executable, tmp_path / "program.py"],
            env=environment,
            capture_output=True,
            text=True,
            check=False,
        )
        return left.stdout + left.stderr

    assert run() == "8.0\n"
    (damaged,) = (tmp_path / "cache").rglob(f"*{ending}")
    whole = damaged.read_bytes()
    damaged.write_bytes(whole[:kept])
    assert run() == "8.0\n"
    (mended,) = (tmp_path / "cache").rglob(f"*{ending}")
    assert len(mended.read_bytes()) == len(whole)


def test_code_of_another_signature_is_compiled_anew(tmp_path: Path) -> None:
    """As two processes that compile at once can leave it: each gave its own code the same name."""
    program = "from pointpred.compiled import law\n@law\ndef f(x):\n    return x + x\nprint(f(4), f(0.25))"
    (tmp_path / "program.py").write_text(program)
    environment = {**os.environ, "POINTPRED_CACHE_DIR": str(tmp_path / "cache")}
    command = [sys.executable, str(tmp_path / "program.py")]

    def run() -> str:
        return subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout

    assert run() == "8 0.5\n"
    waits = "from pointpred.compiled import awaits_compiling, law\n@law\ndef f(x):\n    return x * x\n"
    (tmp_path / "waits.py").write_text(f"{waits}print(awaits_compiling(f), f(4), awaits_compiling(f))")
    asked = [sys.executable, str(tmp_path / "waits.py")]
    assert subprocess.check_output(asked, env=environment, text=True) == "True 16 False\n"
    one, other = sorted((tmp_path / "cache").rglob("program*.nbc"))
    one.write_bytes(other.read_bytes())
    assert run() == "8 0.5\n"
    assert run() == "8 0.5\n"


def test_a_user_without_a_home_gets_a_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def homeless() -> Path:
        raise RuntimeError("Could not determine home directory.")

    for name in ("POINTPRED_CACHE_DIR", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(Path, "home", homeless)
    monkeypatch.setattr(compiled.tempfile, "gettempdir", lambda: str(tmp_path))
    folder = compiled._cache_folder.__wrapped__()
    assert folder is not None
    assert folder.parent == tmp_path
