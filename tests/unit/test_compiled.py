"""The cache of compiled laws notices what numba does not: a change in what a law reaches."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import FunctionType
from typing import Any

import pytest

from pointpred import compiled
from pointpred.stage import loop_into, loop_of

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


def test_a_loop_around_another_step_is_cached_in_another_folder(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """The loops of all stages have one source; what differs is what they close over."""
    monkeypatch.setattr(compiled, "_cache_folder", lambda: tmp_path)

    def folder(loop: Any) -> str:
        return str(loop.stats.cache_path)

    assert folder(loop_of(doubled, tripled)) == folder(loop_of(doubled, tripled))
    loops = [loop_of(doubled, tripled), loop_of(tripled, tripled), loop_of(doubled, quadrupled)]
    loops += [loop_of(doubled, tripled, doubled), loop_into(doubled), loop_into(tripled)]
    assert len(set(map(folder, loops))) == len(loops)


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


ONE = "from pointpred.compiled import law\n@law\ndef f(x):\n    return 2.0 * x\nprint(f(4.0))\n"
SEALED = f"""
import os, sys
seen = {{"read": 0, "written": 0}}
from numba.core import caching
load = caching.IndexDataCacheFile.load
def counted(self, key):
    found = load(self, key)
    seen["read"] += found is not None
    return found
caching.IndexDataCacheFile.load = counted
if sys.argv[1] != "writable":
    caching.IndexDataCacheFile.save = lambda *_: seen.update(written=seen["written"] + 1)
if sys.argv[1] == "sealed":
    access = os.access
    os.access = lambda path, mode: mode == os.R_OK and access(path, mode)
    from tempfile import TemporaryFile
    def refused(*a, **k): raise PermissionError(13, "read-only")
    caching.tempfile.TemporaryFile = refused
{ONE}
print(seen["read"] > 0, seen["written"] > 0)
"""


def told(program: Path, cache: Path, *arguments: str) -> str:
    """What a program writes that keeps its code in a folder of its own."""
    run = subprocess.run(
        [sys.executable, program, *arguments],
        env={**os.environ, "POINTPRED_CACHE_DIR": str(cache)},
        capture_output=True,
        text=True,
        check=False,
    )
    return run.stdout + run.stderr


def test_a_cache_that_is_only_read_is_used_and_not_written(tmp_path: Path) -> None:
    program, cache = tmp_path / "program.py", tmp_path / "cache"
    cache.mkdir()
    program.write_text(SEALED)
    assert told(program, cache, "writable") == "8.0\nFalse False\n"
    assert told(program, cache, "sealed") == "8.0\nTrue False\n"
    assert told(program, cache, "open") == "8.0\nTrue False\n"
    for path in sorted(cache.rglob("*"), reverse=True):
        path.rmdir() if path.is_dir() else path.unlink()
    assert told(program, cache, "sealed") == "8.0\nFalse False\n"
    assert not list(cache.iterdir())


@pytest.mark.parametrize(("old", "new", "answer"), [("2.0", "20.0", 32.0), ("3.0", "30.0", 122.0)])
def test_what_a_law_reads_through_a_module_is_part_of_it(
    tmp_path: Path, old: str, new: str, answer: float
) -> None:
    """An upgrade that changes a constant or a law in another file runs no machine code of before."""
    program, module, cache = tmp_path / "program.py", tmp_path / "module.py", tmp_path / "cache"
    law = "from pointpred.compiled import law\n"
    program.write_text(
        f"import module\n{law}@law\ndef f(x):\n    return module.K + module.g(x)\nprint(f(4.0))\n"
    )
    module.write_text(f"{law}K = 2.0\n@law\ndef g(x):\n    return 3.0 * x\n")
    assert told(program, cache) == "14.0\n"
    module.write_text(module.read_text().replace(old, new))
    assert told(program, cache) == f"{answer}\n"


def test_damaged_files_of_the_cache_are_compiled_anew(tmp_path: Path) -> None:
    """As a full disk leaves them, each of another law; the next process mends them."""
    damages = [(ending, kept) for ending in (".nbi", ".nbc") for kept in (0, 7, 60)]
    program, cache = tmp_path / "program.py", tmp_path / "cache"
    names = [f"f{kept}_{ending[1:]}" for ending, kept in damages]
    program.write_text(
        "from pointpred.compiled import law\n"
        + "".join(f"@law\ndef {name}(x):\n    return {k}.0 * x\n" for k, name in enumerate(names))
        + f"print({', '.join(f'{name}(4.0)' for name in names)})\n"
    )
    expected = " ".join(f"{4.0 * k}" for k in range(len(names))) + "\n"
    assert told(program, cache) == expected
    whole: dict[Path, int] = {}
    for name, (ending, kept) in zip(names, damages, strict=True):
        (damaged,) = cache.rglob(f"*{name}*{ending}")
        whole[damaged] = damaged.stat().st_size
        damaged.write_bytes(damaged.read_bytes()[:kept])
    assert told(program, cache) == expected
    assert {path: path.stat().st_size for path in whole} == whole


def test_code_of_another_signature_is_compiled_anew(tmp_path: Path) -> None:
    """As two processes that compile at once can leave it: each gave its own code the same name."""
    program = "from pointpred.compiled import law\n@law\ndef f(x):\n    return x + x\nprint(f(4), f(0.25))"
    (tmp_path / "program.py").write_text(program)
    cache = tmp_path / "cache"
    assert told(tmp_path / "program.py", cache) == "8 0.5\n"
    waits = "from pointpred.compiled import awaits_compiling, law\n@law\ndef f(x):\n    return x * x\n"
    (tmp_path / "waits.py").write_text(f"{waits}print(awaits_compiling(f), f(4), awaits_compiling(f))")
    assert told(tmp_path / "waits.py", cache) == "True 16 False\n"
    one, other = sorted(cache.rglob("program*.nbc"))
    one.write_bytes(other.read_bytes())
    assert told(tmp_path / "program.py", cache) == "8 0.5\n"
    assert told(tmp_path / "program.py", cache) == "8 0.5\n"


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
