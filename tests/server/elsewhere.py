"""``python -X warn_default_encoding elsewhere.py FOLDER``: the package as Windows would give it to its users.

The modules of pointpred, and no others, see an ``os``, a ``signal`` and so on without what only Unix has, and
cannot import Unix's modules. Everything is imported, the service serves and records, and the command line
scores. Prints JSON.
"""

from __future__ import annotations

import builtins
import json
import pkgutil
import socket
import sys
import threading
import warnings
from asyncio import BaseEventLoop
from contextlib import redirect_stdout
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any
from urllib.request import urlopen

UNIX = {
    "fcntl",
    "grp",
    "hidraw",
    "posix",
    "pty",
    "pwd",
    "readline",
    "resource",
    "syslog",
    "termios",
    "tty",
    "uvloop",
    "Xlib",
}
GONE = {
    "os": """O_ASYNC O_CLOEXEC O_DIRECT O_DIRECTORY O_DSYNC O_NOCTTY O_NOFOLLOW O_NONBLOCK O_PATH O_SYNC
        O_TMPFILE chown chroot ctermid eventfd fchdir fchmod fchown fdatasync fork forkpty fpathconf
        fstatvfs get_blocking getegid geteuid getgid getgroups getloadavg getpgid getpgrp
        getpriority getsid getuid getxattr initgroups killpg lchown lockf memfd_create mkfifo mknod
        nice openpty pathconf pidfd_open pipe2 posix_fadvise posix_fallocate posix_spawn pread
        preadv pwrite pwritev readv register_at_fork sched_getaffinity sched_setaffinity
        sched_setscheduler sched_yield sendfile set_blocking setgid setpriority setsid setuid
        setxattr statvfs sync sysconf tcgetpgrp ttyname uname wait wait3 wait4 writev WNOHANG""",
    "signal": """SIGALRM SIGCHLD SIGCONT SIGHUP SIGKILL SIGPIPE SIGQUIT SIGSTOP SIGTSTP SIGUSR1 SIGUSR2
        SIGWINCH alarm pause pthread_kill pthread_sigmask setitimer siginterrupt sigtimedwait sigwait""",
    "socket": "AF_UNIX SO_REUSEPORT recv_fds send_fds",
    "select": "epoll poll kqueue",
    "time": "CLOCK_MONOTONIC CLOCK_REALTIME clock_gettime clock_settime pthread_getcpuclockid tzset",
}  # fmt: skip
OTHER = {
    "os": {"name": "nt", "O_BINARY": 0},
    "sys": {"platform": "win32"},
    "socket": {"SO_EXCLUSIVEADDRUSE": socket.SO_REUSEADDR},
}


class Foreign(ModuleType):
    """A module as another system has it."""

    def __init__(self, real: ModuleType) -> None:
        super().__init__(real.__name__)
        self.__dict__.update(vars(real))
        for name in GONE.get(real.__name__, "").split():
            self.__dict__.pop(name, None)
        self.__dict__.update(OTHER.get(real.__name__, {}))


def emigrate() -> None:
    """From now on modules of pointpred import what Windows has."""
    real = builtins.__import__
    foreign = {name: Foreign(import_module(name)) for name in {*GONE, *OTHER}}

    def given(name: str, globals: Any = None, *rest: Any, **more: Any) -> ModuleType:
        if str((globals or {}).get("__name__")).startswith("pointpred"):
            if name.partition(".")[0] in UNIX:
                raise ModuleNotFoundError(f"No module named {name!r} on Windows", name=name)
            if name in foreign:
                return foreign[name]
        return real(name, globals, *rest, **more)

    builtins.__import__ = given
    sys.modules["uvloop"] = None  # type: ignore[assignment]
    for name in ("add_signal_handler", "add_reader", "add_writer"):
        setattr(BaseEventLoop, name, _not_there)
        for kind in BaseEventLoop.__subclasses__():
            if name in vars(kind):
                setattr(kind, name, _not_there)


def _not_there(*_: object) -> None:
    raise NotImplementedError


def imported() -> int:
    """Import every module; returns how many there are."""
    import pointpred

    def fail(name: str) -> None:
        raise ImportError(name)

    names = [one.name for one in pkgutil.walk_packages(pointpred.__path__, "pointpred.", fail)]
    for name in names:
        if not name.endswith("__main__"):
            import_module(name)
    return len(names)


def served(folder: Path) -> dict[str, Any]:
    """A session with predictions, recorded to disk; and the page."""
    from pointpred import PointerEvent
    from pointpred.client import connect
    from pointpred_server.listening import address, listen, make_server
    from pointpred_server.service import Service
    from pointpred_server.settings import Settings

    opened, up = listen("127.0.0.1", 0), threading.Event()
    server = make_server(Service(Settings(record=folder)), up.set)
    thread = threading.Thread(target=server.run, args=([opened],))
    thread.start()
    try:
        assert up.wait(600.0)
        url = address("127.0.0.1", opened)
        page = urlopen(url).read()
        with connect(url, predictor="hold") as connection:
            connection.trial("start", {"x": 59.0, "y": 0.0, "width": 20.0})
            connection.send([PointerEvent(0.01 * i, float(i), 0.0) for i in range(60)])
            newest = list(connection.predictions())[-1]
            connection.trial("end")
    finally:
        server.should_exit = True
        thread.join()
        opened.close()
    return {"page": b"<html" in page or b"<!doctype html" in page.lower(), "x": newest.x}


def scored(file: Path) -> dict[str, Any]:
    """What the command line makes of a recording."""
    from pointpred.cli import main

    target, code = file.with_suffix(".json"), None
    try:
        main(["score", str(file), "--predictors", "hold", "--json", str(target)])
    except SystemExit as end:
        code = end.code
    return {"code": code, "trials": json.loads(target.read_bytes())["sets"][0]["trials"]}


if __name__ == "__main__":
    warnings.filterwarnings("error", category=EncodingWarning, module=r"pointpred(\.|$)")
    emigrate()
    folder = Path(sys.argv[1])
    told: dict[str, Any] = {"modules": imported(), **served(folder)}
    (samples,) = folder.glob("*_samples.csv")
    with redirect_stdout(sys.stderr):
        told |= scored(samples)
    print(json.dumps(told))
