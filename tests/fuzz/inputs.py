"""Damaged public recordings through ``read_any``: ``python -m tests.fuzz.inputs FOLDER``.

Takes the files of ``inputs.toml`` in FOLDER. Each is cut, its bytes, lines and numbers are changed, 40 times
or ``--each``, by a generator whose seed is the file's SHA-256; half of the damaged files are read with the
options of the list, half with a mapping made of random columns, fields and units. Reading must end in
a recording that is in order or in an error of pointpred's own that names the file, within 5 s of the
processor and 1 GiB. What does not is kept in a folder that is named, and the command ends in an error.
Keeps its numbers for ``docs/evidence/inputs.md``. Linux only.
"""

from __future__ import annotations

import argparse
import gc
import gzip
import multiprocessing
import random
import re
import sys
import tempfile
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from evidence.data import keep
from evidence.inputs.measure import LIST, OUT, File, listed, reading_of
from pointpred.errors import PointpredError
from pointpred.recording import Recording
from pointpred.recordings import read_any
from pointpred.recordings.reading import FIELDS, Reading

EACH = 40
MOST_BYTES = 256 << 10
"""Of a larger file, but for JSON, only the first lines are damaged, so that many can be tried."""
MOST_S, MOST_MIB = 5.0, 1024.0
INSTEAD = (
    *(b"", b"-1", b"1e308", b"9" * 30, b"nan", b"inf", b"1.5.2", b"\xff\xfe", b"'", b'"', b"[", b"]"),
    *(
        b"null",
        b"true",
        b"[]",
        b"{}",
        b'""',
        b"[1,[2,{}]]",
        b'{"x":1}',
        b"1,2",
        b"1;2",
        b"\r",
        b"2024-01-01 00:00",
    ),
)
"""What numbers are changed to."""
GZIP = b"\x1f\x8b"
WORDS = re.compile(rb"[A-Za-z_][\w .-]{0,30}")
STRANGE = (
    "",
    " ",
    "-1",
    "0",
    "7",
    "999",
    "t",
    "x",
    "\u00e9",
    "a,b",
    "data.trials",
    "..",
    "[0]",
    "nan",
    "\x00",
)


class Result(msgspec.Struct):
    """What a file's damaged copies ended in, the most memory and time, and what broke."""

    ends: Counter[str] = msgspec.field(default_factory=Counter)
    mib: float = 0.0
    s: float = 0.0
    broken: list[str] = []


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path, metavar="FOLDER")
    parser.add_argument("--each", type=int, default=EACH, help="damaged copies of a file")
    parser.add_argument("--seed", default="", help="other damages than those of the page")
    parser.add_argument("--only", default="", help="files whose path holds this")
    parser.add_argument("--out", type=Path, default=OUT, help="the numbers, instead of the page's JSON")
    given = parser.parse_args(arguments)
    files = [file for file in listed(LIST) if file.under(given.folder).is_file() and given.only in file.path]
    kept = Path(tempfile.mkdtemp(prefix="broken-"))
    total = Result()
    for number, file in enumerate(files, 1):
        result = apart(file, given, kept)
        total.ends += result.ends
        total.mib, total.s = max(total.mib, result.mib), max(total.s, result.s)
        total.broken += result.broken
        print(f"{number} of {len(files)} {file.path}: {said(result)}", file=sys.stderr)
    for line in total.broken:
        print(line, file=sys.stderr)
    if not given.only and not given.seed:
        counts = {"copies": sum(total.ends.values()), "files": len(files), "broken": len(total.broken)}
        ends = {"read": total.ends["read"], "refused": total.ends["refused"]}
        most = {"mib": round(total.mib), "s": round(total.s, 1)}
        keep("inputs", {}, numbers={"fuzz": {**counts, **ends, **most}}, file=given.out)
    raise SystemExit(bool(total.broken))


def said(result: Result) -> str:
    """A result in one line."""
    return (
        f"{result.ends['read']} are read, {result.ends['refused']} refused by an error that names the file "
        f"and {len(result.broken)} broke; each took at most {result.mib:.0f} MiB and {result.s:.1f} s"
    )


def apart(file: File, given: argparse.Namespace, kept: Path) -> Result:
    """``fuzz`` in a process of its own, whose end is a result as well."""
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)
    child = context.Process(target=_send, args=(sender, file, given, kept))
    child.start()
    sender.close()
    try:
        result: Result = receiver.recv()
    except EOFError:
        result = Result(broken=[f"{file.path}: the process ended without a word; the copy is in {kept}"])
    child.join()
    return result


def _send(sender: Any, file: File, given: argparse.Namespace, kept: Path) -> None:
    sender.send(fuzz(file, given.folder, given.each, kept, given.seed))
    sender.close()


def fuzz(file: File, folder: Path, each: int, kept: Path, seed: str = "") -> Result:
    """Damage a file ``each`` times and read every copy."""
    result = Result()
    chance = random.Random(file.sha256 + seed)
    whole = file.under(folder).read_bytes()
    packed = whole.startswith(GZIP)
    data = gzip.decompress(whole) if packed else whole
    binary = b"\x00" in data[:4096]
    if not binary and data.lstrip()[:1] not in (b"[", b"{") and len(data) > MOST_BYTES:
        data = data[: data.rfind(b"\n", 0, MOST_BYTES) + 1]
    names = sorted({word.decode() for word in WORDS.findall(data[:20000])})[:200]
    suffix = "".join(Path(file.path).suffixes[-2:])
    for number in range(each):
        damaged = data
        for _ in range(chance.choice([1, 1, 2, 4])):
            damaged = chance.choice(DAMAGES)(damaged or data, chance)
        if packed:
            damaged = gzip.compress(damaged, 1)
            damaged = chance.choice(DAMAGES)(damaged, chance) if chance.random() < 0.3 else damaged
        path = kept / f"{file.sha256[:8]}_{number}{suffix}"
        path.write_bytes(damaged)
        reading = reading_of(file) if number % 2 else strange_reading(names, chance)
        end = one(path, reading, result)
        if end in ("read", "refused"):
            path.unlink()
            result.ends[end] += 1
        else:
            result.ends["broke"] += 1
            result.broken.append(f"{path} ({file.path}), {msgspec.to_builtins(reading)}: {end}")
    return result


def one(path: Path, reading: Reading | None, result: Result) -> str:
    """Read one copy: ``read``, ``refused`` or what broke in words."""
    gc.collect()
    Path("/proc/self/clear_refs").write_text("5", encoding="ascii")  # the peak of memory starts anew
    held, began = _peak_mib(), time.process_time()
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for recording in read_any(path, reading or Reading()):
                check(recording)
        end = "read"
    except PointpredError as error:
        end = "refused" if path.name in str(error) else f"an error without the file's name: {error}"
    except BaseException:
        end = traceback.format_exc()
    lasted, peak = time.process_time() - began, _peak_mib() - held
    result.mib, result.s = max(result.mib, peak), max(result.s, lasted)
    if lasted > MOST_S or peak > MOST_MIB:
        end = f"{lasted:.1f} s, {peak:.0f} MiB; {end}"
    return end


def check(recording: Recording) -> None:
    """Raise AssertionError where a recording is not in order."""
    table, offsets = recording.events.table, recording.offsets
    assert len(offsets) == len(recording.trials) + 1, "offsets"
    assert np.isfinite(table[:, :3]).all(), "a time or position that is not finite"
    steps = np.diff(table[:, 0])
    inside = np.ones(len(steps), dtype=bool)
    inside[offsets[1:-1] - 1] = False
    assert (steps[inside] >= 0).all(), "time that goes backwards"
    assert (np.diff(offsets) >= 2).all(), "a trial of one sample"


def strange_reading(names: list[str], chance: random.Random) -> Reading | None:
    """A mapping that nobody made for the file; ``None`` where ``Reading`` itself refuses it."""

    def column() -> str | int:
        pick = chance.random()
        if pick < 0.7 and names:
            return chance.choice(names)
        return chance.choice(STRANGE) if pick < 0.9 else chance.randrange(-2, 40)

    fields = chance.sample(FIELDS, chance.randrange(1, len(FIELDS)))
    told: dict[str, Any] = {
        "columns": {field: column() for field in {"t", "x", "y"} | set(fields)}
        if chance.random() < 0.8
        else None,
        "time_unit": chance.choice([None, "s", "ms", "us", "ns", "iso"]),
        "y_up": chance.random() < 0.3,
        "px_per_unit": chance.choice([None, None, 1e-9, 96.0, 1e300]),
        "cut": chance.choice([None, "clicks", "bursts", "whole"]),
    }
    try:
        return Reading(**told)
    except PointpredError:
        return None


def _cut(data: bytes, chance: random.Random) -> bytes:
    return data[: chance.randrange(len(data) + 1)]


def _flip(data: bytes, chance: random.Random) -> bytes:
    changed = bytearray(data)
    for _ in range(chance.randrange(1, 20)):
        changed[chance.randrange(len(changed))] = chance.randrange(256)
    return bytes(changed)


def _head(data: bytes, chance: random.Random) -> bytes:
    """Change bytes among the first, where headers are."""
    return _flip(data[:200], chance) + data[200:]


def _hole(data: bytes, chance: random.Random) -> bytes:
    start, stop = sorted(chance.randrange(len(data) + 1) for _ in range(2))
    return data[:start] + data[stop:]


def _lines(data: bytes, chance: random.Random) -> bytes:
    """Swap two lines, drop one and double one."""
    lines = data.split(b"\n")
    first, second = (chance.randrange(len(lines)) for _ in range(2))
    lines[first], lines[second] = lines[second], lines[first]
    del lines[chance.randrange(len(lines))]
    if lines:
        lines.insert(chance.randrange(len(lines)), lines[chance.randrange(len(lines))])
    return b"\n".join(lines)


def _digits(data: bytes, chance: random.Random) -> bytes:
    """Make numbers large, negative, empty or words."""
    found = list(re.finditer(rb"[\d.]+", data[: chance.choice([500, 50000])]))
    if not found:
        return _flip(data, chance)
    spot = chance.choice(found)
    new = chance.choice(INSTEAD)
    return data[: spot.start()] + new + data[spot.end() :]


DAMAGES: list[Callable[[bytes, random.Random], bytes]] = [_cut, _flip, _head, _hole, _lines, _digits]


def _peak_mib() -> float:
    """The most memory this process has held since ``clear_refs``."""
    status = Path("/proc/self/status").read_text(encoding="ascii")
    found = re.search(r"VmHWM:\s+(\d+) kB", status)
    return int(found[1]) / 1024 if found else 0.0


if __name__ == "__main__":
    main()
