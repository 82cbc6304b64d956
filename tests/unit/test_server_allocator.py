"""Free memory goes back to the system, and a process takes no more than it touches."""

from __future__ import annotations

import platform
import subprocess
import sys

import pytest

pytestmark = pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="the C library is not glibc")

AFTER_A_LARGER_BLOCK = """
import ctypes, re
from pathlib import Path
from pointpred_server.allocator import bound_free_memory

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


def run(code: str, bound: str) -> int:
    """The kB that the code prints, with ``bound`` before it."""
    code = code.replace("BOUND", bound)
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    return int(out.stdout)


def test_a_large_block_changes_nothing_for_those_after_it() -> None:
    assert run(AFTER_A_LARGER_BLOCK, "pass") > 10_000, "what glibc does by itself"
    assert run(AFTER_A_LARGER_BLOCK, "bound_free_memory()") < 2_000


IN_HUGE_PAGES = """
import mmap, re
from pathlib import Path
from pointpred_server.allocator import bound_free_memory

BOUND
block = mmap.mmap(-1, 32 * 2**20, flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
block.madvise(mmap.MADV_HUGEPAGE)
for start in range(0, len(block), 2 * 2**20):
    block[start] = 1  # one byte in each 2 MiB
print(sum(map(int, re.findall(r"AnonHugePages:\\s+(\\d+)", Path("/proc/self/smaps").read_text()))))
"""


def test_memory_is_taken_in_small_pages_whatever_a_library_asks_for() -> None:
    if run(IN_HUGE_PAGES, "pass") < 20_000:
        pytest.skip("this kernel gives no huge pages")
    assert run(IN_HUGE_PAGES, "bound_free_memory()") == 0
