"""The same text in any encoding, packed or not, gives the same recording; what is no text is refused."""

from __future__ import annotations

import gzip
import io
import tracemalloc
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pointpred.errors import RecordingError
from pointpred.recordings import Reading, format_of, read, read_any
from pointpred.recordings import encodings as decoding
from pointpred.recordings.encodings import (
    encoding_of,
    head_of,
    is_ended,
    open_text,
    read_text,
)

SOURCES = Path(__file__).parents[1] / "data/sources"
TEXT = "name,x\nJosé,1\nŽofie,2\n"


@pytest.mark.parametrize("packed", [False, True], ids=["", "gzip"])
@pytest.mark.parametrize("ends", ["\n", "\r\n", "\r"], ids=["LF", "CRLF", "CR"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "cp1252"])
def test_text_comes_back_whatever_its_encoding(
    tmp_path: Path, encoding: str, ends: str, packed: bool
) -> None:
    data = TEXT.replace("\n", ends).encode(encoding)
    path = tmp_path / "file"
    path.write_bytes(gzip.compress(data) if packed else data)
    assert read_text(path) == TEXT
    assert head_of(path).decode().splitlines() == TEXT.splitlines()
    assert is_ended(path)
    assert bool(encoding_of(path).note) == (encoding == "cp1252")
    with open_text(path) as lines:
        assert list(lines) == TEXT.splitlines(keepends=True)


def test_both_byte_orders_and_a_file_without_a_last_line_end(tmp_path: Path) -> None:
    path = tmp_path / "file"
    for mark, name in ((b"\xff\xfe", "utf-16-le"), (b"\xfe\xff", "utf-16-be")):
        path.write_bytes(mark + TEXT.strip().encode(name))
        assert read_text(path) == TEXT.strip()
        assert not is_ended(path)


def test_a_byte_without_meaning_in_windows_1252_is_latin_1(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"\xe9 \x81")
    assert encoding_of(path).name == "latin-1"
    assert encoding_of(path).odd == 0
    assert read_text(path) == "\xe9 \x81"


def test_a_character_across_two_blocks_is_no_fault(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(decoding, "BLOCK_BYTES", 3)
    path = tmp_path / "file"
    path.write_text("aéßžö€", encoding="utf-8")
    assert encoding_of(path).name == "utf-8-sig"
    path.write_bytes("aéß".encode() + b"\xe9")
    assert encoding_of(path).odd == 5
    path.write_bytes("aéß€".encode()[:-1])
    assert encoding_of(path).odd == 5


@pytest.mark.parametrize(
    "data",
    [
        b"\x89PNG\r\n\x1a\n\0\0",
        b"text\0",
        TEXT.encode("utf-16-le"),
        b"\xe9\x02",
        b"\xff\xfea",
        b"\xfe\xff\xd8\x00",
    ],
)
@pytest.mark.parametrize("packed", [False, True])
def test_what_is_no_text_is_refused(tmp_path: Path, data: bytes, packed: bool) -> None:
    path = tmp_path / "file"
    path.write_bytes(gzip.compress(data) if packed else data)
    with pytest.raises(RecordingError, match="file: ") as refused:
        read_text(path)
    utf_16 = data.startswith((b"\xff\xfe", b"\xfe\xff"))
    assert refused.value.code == ("damaged_file" if utf_16 else "not_text")


@pytest.mark.parametrize("keep", [3, 12, 30])
def test_a_damaged_gzip_file_is_refused(tmp_path: Path, keep: int) -> None:
    path = tmp_path / "file.gz"
    path.write_bytes(gzip.compress(TEXT.encode())[:keep])
    with pytest.raises(RecordingError, match=r"file\.gz: ") as refused:
        read_text(path)
    assert refused.value.code == "damaged_file"
    with pytest.raises(RecordingError, match=r"file\.gz: "):
        read_any(path)


def test_what_unpacks_to_too_much_is_refused_before_memory_fills(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(decoding, "MOST_BYTES", 1 << 24)
    path = tmp_path / "file.gz"
    path.write_bytes(gzip.compress(b" " * ((1 << 24) + 1), compresslevel=1))
    tracemalloc.start()
    with pytest.raises(RecordingError, match="16777216 bytes"):
        read_text(path)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 1 << 23


@given(st.binary(max_size=80), st.booleans())
def test_any_bytes_are_text_or_refused(data: bytes, packed: bool) -> None:
    """An independent reader: Python's own codecs on the whole of the bytes, newlines by the io module."""
    with TemporaryDirectory() as folder:
        path = Path(folder) / "file"
        path.write_bytes(gzip.compress(data) if packed else data)
        try:
            read_data = read_text(path)
        except RecordingError:
            read_data = None
    if data.startswith(b"\x1f\x8b\x08") and not packed:
        return
    expected = None
    for name in ("utf-16",) if data[:2] in (b"\xff\xfe", b"\xfe\xff") else ("utf-8-sig", "cp1252", "latin-1"):
        try:
            expected = data.decode(name)
        except UnicodeDecodeError:
            continue
        break
    if expected is not None and name != "utf-16":
        controls = set(range(9)) | set(range(14, 27)) | set(range(28, 32))
        bad = {0} if name == "utf-8-sig" else controls
        expected = None if bad & set(data) else expected
    if expected is not None:
        expected = io.TextIOWrapper(io.BytesIO(expected.encode()), "utf-8", newline=None).read()
    assert read_data == (expected if expected and expected.strip() else None)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16", "utf-8-sig"])
@pytest.mark.parametrize("ends", ["\n", "\r"], ids=["LF", "CR"])
@pytest.mark.parametrize(
    "name",
    [
        *("gofitts.sd3", "jspsych.csv", "jspsych.json", "mousetrap.csv", "psychopy.csv", "evtest.txt"),
        *("mouse.evemu", "libinput.yml", "hid-recorder.txt", "user7/session_0000000001", "pair_samples.csv"),
    ],
)
def test_every_text_format_reads_packed_and_encoded(
    tmp_path: Path, name: str, encoding: str, ends: str
) -> None:
    folder = tmp_path / "user7"
    folder.mkdir()
    text = (SOURCES / name).read_text(encoding="utf-8").replace("\n", ends)
    path = folder / f"{Path(name).name}.gz"
    path.write_bytes(gzip.compress(text.encode(encoding)))
    [expected] = read_any(SOURCES / name)
    [found] = read_any(path)
    assert format_of(path) == format_of(SOURCES / name)
    assert found.name == expected.name
    assert [trial.trial for trial in found.trials] == [trial.trial for trial in expected.trials]
    np.testing.assert_array_equal(found.events.table, expected.events.table)


@pytest.mark.parametrize("name", ["pair", "recorded"])
def test_names_beside_each_other_match_when_packed(tmp_path: Path, name: str) -> None:
    for part in ("samples", "trials"):
        file = f"{name}_{part}.csv"
        (tmp_path / f"{file}.gz").write_bytes(gzip.compress((SOURCES / file).read_bytes()))
    whole = read(SOURCES / f"{name}_samples.csv")
    packed = read(tmp_path / f"{name}_samples.csv.gz")
    assert packed.name == whole.name
    assert repr(packed.trials) == repr(whole.trials)
    assert [found.name for found in read_any(tmp_path)] == [whole.name]


def test_returns_alone_lose_no_trial_and_the_last_row_may_be_cut(tmp_path: Path) -> None:
    path = tmp_path / "mac_samples.csv"
    rows = ["user,trial,t_s,x_px,y_px", "u,a,0,0,0", "u,a,1,1,1", "u,b,0,0,0", "u,b,1,1,1"]
    path.write_bytes("\r".join([*rows, ""]).encode())
    assert [trial.trial for trial in read(path).trials] == ["a", "b"]
    path.write_bytes("\r".join(rows).encode())
    assert [trial.trial for trial in read(path).trials] == ["a"]


def test_a_guessed_encoding_is_said_in_a_note(tmp_path: Path) -> None:
    own = tmp_path / "own_samples.csv"
    own.write_bytes("user,trial,t_s,x_px,y_px\nJosé,a,0,0,0\nJosé,a,1,1,1\n".encode("cp1252"))
    [recording] = read_any(own)
    assert recording.trials[0].user == "José"
    assert sum("Windows-1252" in note for note in recording.notes) == 1
    foreign = tmp_path / "gofitts.sd3"
    foreign.write_bytes((SOURCES / "gofitts.sd3").read_bytes().replace(b"P01", b"P\xe9"))
    [recording] = read_any(foreign)
    assert recording.trials[0].user == "Pé"
    assert sum("Windows-1252" in note for note in recording.notes) == 1


@given(st.integers(0, 200), st.integers(1, 255))
def test_a_gzip_file_with_a_wrong_byte_is_refused_or_reads_the_same(at: int, change: int) -> None:
    data = bytearray(gzip.compress(TEXT.encode() * 20))
    data[at % len(data)] ^= change
    with TemporaryDirectory() as folder:
        path = Path(folder) / "file.gz"
        path.write_bytes(data)
        try:
            found = read_text(path)
        except RecordingError:
            return
    assert found in (TEXT * 20, data.decode("latin-1"))


def test_text_without_the_mark_that_its_named_encoding_needs_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "study.csv"
    path.write_text("t_ms,x,y\n0,1,2\n8,3,4\n16,5,6\n")
    with pytest.raises(RecordingError, match="byte 0 is not utf-16"):
        read_any(path, Reading(encoding="utf-16"))
