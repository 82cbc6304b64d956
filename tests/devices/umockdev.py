"""Emulated devices: libumockdev makes /sys, /dev and ioctls that a program started under its preload sees.

The testbed lives in the process that plays the hand; what is tested runs in a child (``Testbed.python``) that
reads the emulated nodes through the same calls as real ones. A node is a terminal's stream of bytes: what is
written in one piece may be read in two, and two pieces in one, so write slowly; it can be hung up. A node of
``packets`` instead is as hidraw is: a report a read, and a ring that drops what nobody reads.
"""

from __future__ import annotations

import ctypes
import fcntl
import os
import subprocess
import sys
from ctypes import POINTER, byref, c_char_p, c_int, c_void_p
from ctypes.util import find_library
from pathlib import Path
from tempfile import TemporaryDirectory
from types import TracebackType
from typing import Self

PRELOAD = "libumockdev-preload.so.0"


def missing() -> str | None:
    """Why nothing can be emulated here, or ``None``."""
    if sys.platform != "linux":
        return "umockdev emulates Linux devices only"
    return None if find_library("umockdev") else "libumockdev is not installed (Debian: umockdev)"


class Testbed:
    """One emulated machine; closing it removes its devices. Use as a context manager."""

    __test__ = False  # not a class of tests

    def __init__(self) -> None:
        self._library = _library()
        self._bed = self._library.umockdev_testbed_new()
        self._ioctls = TemporaryDirectory()
        self.root = self._text(self._library.umockdev_testbed_get_root_dir(self._bed))
        Path(self.root).chmod(0o755)  # a child may be another user

    def add(self, description: str, ioctls: dict[str, str] | None = None) -> None:
        """Plug in devices described as by umockdev-record; ``ioctls`` are the answers by node."""
        trouble = c_void_p()
        # Answers first: whoever opens a node while its answers are only being made ready is aborted.
        for node, answers in (ioctls or {}).items():
            record = Path(self._ioctls.name, node.replace("/", "_"))
            record.write_text(f"@DEV {node}\n{answers}")
            self._library.umockdev_testbed_load_ioctl(self._bed, None, str(record).encode(), byref(trouble))
            self._check(trouble)
        self._library.umockdev_testbed_add_from_string(self._bed, description.encode(), byref(trouble))
        self._check(trouble)

    def hand(self, node: str) -> int:
        """The descriptor to write what the device at ``node`` sends; the testbed keeps it."""
        descriptor: int = self._library.umockdev_testbed_get_dev_fd(self._bed, node.encode())
        assert descriptor >= 0, node
        return descriptor

    def packets(self, node: str, ring: int = 64) -> int:
        """Make a node give one report a read and hold ``ring`` reports; returns the descriptor to write to.

        A write raises BlockingIOError where the ring is full. The caller closes the descriptor.
        """
        path = Path(self.root + node)
        path.unlink()
        os.mkfifo(path)
        path.chmod(0o666)
        hand = os.open(path, os.O_RDWR)
        fcntl.fcntl(hand, fcntl.F_SETFL, os.O_NONBLOCK | os.O_DIRECT)  # a packet a write
        fcntl.fcntl(hand, fcntl.F_SETPIPE_SZ, ring * os.sysconf("SC_PAGESIZE"))
        return hand

    def remove(self, syspath: str) -> None:
        """Unplug a device and everything below it; its node's name cannot be used again."""
        self._library.umockdev_testbed_remove_device(self._bed, syspath.encode())

    def hang_up(self, node: str) -> None:
        """Take a node away, with what the library leaves behind; whoever reads it is hung up."""
        hand, link = self.hand(node), Path(self.root + node)
        Path(self.root, "dev/.ptymap", str(link.readlink()).replace("/", "_")).unlink()
        Path(self.root, "dev/.node", node.removeprefix("/dev/").replace("/", "_")).unlink()
        link.unlink()
        nothing = os.open(os.devnull, os.O_RDWR)
        os.dup2(nothing, hand)  # the testbed closes its number itself
        os.close(nothing)

    def environment(self) -> dict[str, str]:
        """What a child needs to see the emulated devices."""
        return {**os.environ, "LD_PRELOAD": PRELOAD, "UMOCKDEV_DIR": self.root}

    def python(self, code: str, *arguments: str) -> subprocess.Popen[str]:
        """Start Python code that sees the emulated devices; both its streams are pipes of text."""
        return subprocess.Popen(
            [sys.executable, "-c", code, *arguments],
            env=self.environment(),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def close(self) -> None:
        """Forget every device."""
        if self._bed:
            ctypes.CDLL("libgobject-2.0.so.0").g_object_unref(c_void_p(self._bed))
            self._bed = None
            self._ioctls.cleanup()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    @staticmethod
    def _text(address: int) -> str:
        return ctypes.string_at(address).decode()

    @staticmethod
    def _check(trouble: c_void_p) -> None:
        """A GError is a domain, a code and a message."""
        if trouble.value:
            message = ctypes.cast(trouble.value + 8, POINTER(c_char_p)).contents.value or b""
            raise RuntimeError(f"umockdev: {message.decode()}")


def _library() -> ctypes.CDLL:
    """libumockdev with the types of what is called."""
    library = ctypes.CDLL("libumockdev.so.0")
    for name, result, *types in (
        ("new", c_void_p),
        ("get_root_dir", c_void_p, c_void_p),
        ("add_from_string", c_int, c_void_p, c_char_p, POINTER(c_void_p)),
        ("load_ioctl", c_int, c_void_p, c_char_p, c_char_p, POINTER(c_void_p)),
        ("get_dev_fd", c_int, c_void_p, c_char_p),
        ("remove_device", None, c_void_p, c_char_p),
    ):
        function = getattr(library, f"umockdev_testbed_{name}")
        function.restype, function.argtypes = result, types
    return library


def direct(node: str) -> None:
    """In a child: read an open node without asking the testbed at every read, which takes 150 us.

    The preload forgets the descriptor when it is closed; a copy of it takes its number at once.
    """
    path = os.environ["UMOCKDEV_DIR"] + node
    for link in list(Path("/proc/self/fd").iterdir()):
        if link.is_symlink() and str(link.readlink()) == path:
            number = int(link.name)
            copy = os.dup(number)
            os.close(number)
            os.dup2(copy, number, inheritable=False)
            os.close(copy)
