"""Free memory goes back to the system, whatever was freed before."""

from __future__ import annotations

import platform
import subprocess
import sys

import pytest

pytestmark = pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="the C library is not glibc")

AFTER_A_LARGER_BLOCK = """
import ctypes, re
from pathlib import Path
from pointpred.server.allocator import bound_free_memory

BOUND
library = ctypes.CDLL(None)
library.malloc.restype, library.malloc.argtypes = ctypes.c_void_p, [ctypes.c_size_t]
library.free.restype, library.free.argtypes = None, [ctypes.c_void_p]

def take_and_free(size):
    block = library.malloc(size)
    ctypes.memset(block, 1, size)
    library.free(block)

def held_kb():
    return int(re.search(r"RssAnon:\\s+(\\d+)", Path("/proc/self/status").read_text())[1])

before = held_kb()
take_and_free(24 * 2**20)
take_and_free(20 * 2**20)
print(held_kb() - before)
"""


def kept_kb(bound: str) -> int:
    code = AFTER_A_LARGER_BLOCK.replace("BOUND", bound)
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    return int(out.stdout)


def test_a_large_block_changes_nothing_for_those_after_it() -> None:
    assert kept_kb("pass") > 10_000, "what glibc does by itself"
    assert kept_kb("bound_free_memory()") < 2_000
