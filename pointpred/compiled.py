"""How a law is compiled, and the switch that runs the same source as plain Python.

Every law is a module-level function on floats and flat float64 arrays. ``law`` compiles it with numba:
no fastmath (the compiled law must agree with its source), no GIL (trials run in threads), cached on disk.

numba notices that the file of a law has changed, but not that a law it *calls*, or a constant it reads,
has changed in another file. Each law therefore caches in a folder named after its own code and
everything it reaches, so an upgraded installation never runs stale machine code.

The index of such a folder is a pickle: anyone who can write there can run code as the user. If the user's own
cache is not writable, a temporary folder is used only if the user owns it, others have no access and it is
not a link; else laws are compiled in every process, with a warning.

Environment: ``POINTPRED_COMPILED=0`` runs plain Python; ``POINTPRED_CACHE_DIR`` moves the cache.
"""

from __future__ import annotations

import hashlib
import os
import stat
import tempfile
import warnings
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import Any, TypeVar, cast

COMPILED = os.environ.get("POINTPRED_COMPILED", "1") != "0"
"""False when laws run as plain Python (the reference the compiled ones are tested against)."""

Function = TypeVar("Function", bound=Callable[..., Any])

OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy", "no_cfunc_wrapper": True}
"""The last: laws are called from Python and from laws, never by the entrance from C that numba makes too."""

_fingerprints: dict[int, str] = {}


def law(function: Function) -> Function:
    """Compile a law, or return it as it is when ``POINTPRED_COMPILED=0``."""
    if not COMPILED:
        return function
    import numba

    config: Any = numba.config

    plain = cast(FunctionType, function)
    fingerprint = _fingerprint(plain)
    folder = _cache_folder()
    # The cache's place is fixed when the decorator runs: set it for that moment only.
    elsewhere, config.CACHE_DIR = config.CACHE_DIR, str(folder / fingerprint) if folder else ""
    sealed = folder is not None and _sealed(folder)
    try:
        compiled = numba.njit(cache=folder is not None and not sealed, **OPTIONS)(plain)
        if sealed:
            _only_read(compiled, plain)
        if folder is not None:
            _key_by_signature(compiled)
            _distrust(compiled)
    finally:
        config.CACHE_DIR = elsewhere
    _fingerprints[id(compiled)] = fingerprint
    return cast(Function, compiled)


def _key_by_signature(compiled: Any) -> None:
    """Find a law in its folder by its signature and machine: the folder's name is the digest of its code.

    numba's own key also pickles what a closure refers to; a compiled law pickles differently in each process.
    """

    def key(signature: Any, target: Any) -> tuple[Any, ...]:
        return signature, target.magic_tuple()

    compiled._cache._index_key = key


@cache
def _sealed(folder: Path) -> bool:
    """Whether a cache exists but is read-only, as in an image with a read-only file system."""
    return folder.is_dir() and not os.access(folder, os.W_OK)


def _only_read(compiled: Any, plain: FunctionType) -> None:
    """Let a law use a read-only cache, which numba itself refuses.

    What is missing there is compiled anew in each process.
    """
    from numba.core import caching

    class Locator(caching.UserProvidedCacheLocator):
        def ensure_cache_path(self) -> None:
            """Nothing is made."""

    class Reader(caching.CompileResultCacheImpl):
        """Looks in that place only."""

    class Kept(caching.FunctionCache):
        _impl_class = Reader

        def save_overload(self, sig: Any, data: Any) -> None:
            """Nothing is written."""

    Reader._locator_classes = [Locator]
    keep: Any = Kept
    compiled._cache = keep(plain)


def awaits_compiling(function: Any) -> bool:
    """Whether a law would be compiled when it is called, and kept for other processes."""
    folder = getattr(getattr(function, "stats", None), "cache_path", None)
    return folder is not None and not any(Path(folder).glob("*.nbi"))


def _distrust(compiled: Any) -> None:
    """Compile anew where the cached code cannot be loaded, as after a full disk or a killed process.

    Or where it is the code of another signature: numba gives names without a lock, so that two processes that
    compile at once may write under the same one.
    """
    from numba.core import sigutils

    arguments: Any = sigutils.normalize_signature
    store = compiled._cache
    load = store.load_overload

    def load_or_forget(signature: Any, context: Any) -> Any:
        try:
            code = load(signature, context)
            if code is None or code.signature.args == arguments(signature)[0]:
                return code
            raise ValueError("the code of another signature")
        except Exception:  # any error of a damaged pickle or damaged machine code
            try:
                store.flush()
            except OSError:
                store.disable()
            return None

    store.load_overload = load_or_forget


def layout(function: Function) -> Function:
    """Mark a function that lays out a memory or checks one: laws may call it, and it stays plain Python.

    Laying out a memory when a module is imported then loads no machine code.
    """
    if not COMPILED:
        return function
    from numba.extending import register_jitable

    _fingerprints[id(function)] = _fingerprint(cast(FunctionType, function))
    jitable: Function = register_jitable(function)
    return jitable


@cache
def _cache_folder() -> Path | None:
    """The folder of compiled code: the chosen one, else the user's cache, a temporary one, or none."""
    chosen = os.environ.get("POINTPRED_CACHE_DIR")
    if chosen:
        return Path(chosen)
    try:
        own = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "pointpred"
    except (RuntimeError, KeyError):  # neither HOME nor an entry of this user anywhere
        own = Path("~", ".cache", "pointpred")
    try:
        if not own.is_absolute():
            raise OSError("no folder of this user")
        own.mkdir(parents=True, exist_ok=True)
        if os.access(own, os.W_OK):
            return own
    except OSError:
        pass
    shared = Path(tempfile.gettempdir()) / f"pointpred-{os.getuid() if hasattr(os, 'getuid') else 'user'}"
    if _private(shared):
        return shared
    warnings.warn(
        f"pointpred compiles anew in every process: {own} cannot be written and {shared} is not a folder of "
        "this user alone; name another with POINTPRED_CACHE_DIR",
        RuntimeWarning,
        stacklevel=2,
    )
    return None


def _private(folder: Path) -> bool:
    """Whether a folder in a place that others may write to is ours alone; it is made where it is missing."""
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
        status = folder.lstat()
    except OSError:
        return False
    if not stat.S_ISDIR(status.st_mode):
        return False
    # Without user ids (Windows) the temporary folder is the user's own already.
    return not hasattr(os, "getuid") or (status.st_uid == os.getuid() and status.st_mode & 0o077 == 0)


def _fingerprint(function: FunctionType) -> str:
    """A digest of a law's code, the laws it calls and the constants it reads."""
    code = function.__code__
    parts = [function.__module__, code.co_code.hex(), _constants(code)]
    parts += [_value(cell.cell_contents) for cell in function.__closure__ or ()]
    for name in code.co_names:
        value = function.__globals__.get(name)
        if isinstance(value, ModuleType):
            parts += [_value(getattr(value, other, None)) for other in code.co_names]
        else:
            parts.append(_value(value))
    return hashlib.blake2b("\n".join(parts).encode(), digest_size=12).hexdigest()


def _constants(code: CodeType) -> str:
    return repr([constant for constant in code.co_consts if not isinstance(constant, CodeType)])


def _value(value: object) -> str:
    if isinstance(value, int | float | str | tuple):
        return repr(value)
    return _fingerprints.get(id(value), "")
