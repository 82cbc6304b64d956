"""Tables in JSON, MATLAB files, workbooks and XDF: one known truth, whatever holds it."""

from __future__ import annotations

import gzip
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from openpyxl import Workbook
from scipy.io import loadmat, savemat

from pointpred import extras
from pointpred.errors import MissingExtraError, RecordingError
from pointpred.recordings import Reading, read_any
from pointpred.recordings.formats import matlab, xdf
from pointpred.recordings.formats import xlsx as workbook
from tests.unit.writing_containers import (
    ROWS,
    TRIALS,
    WRITERS,
    chunk,
    clock_offset,
    stream_header,
    stream_samples,
    write_workbook,
    write_xdf,
)

T, X, Y = (np.array([row[at] for row in ROWS]) for at in range(3))


@pytest.mark.parametrize("extension", ["csv", "json", "mat", "xlsx"])
def test_the_same_table_in_every_container(extension: str, tmp_path: Path) -> None:
    path = tmp_path / f"own.{extension}"
    WRITERS[extension](path)
    (recording,) = read_any(path)
    assert not recording.skipped
    assert [(trial.user, trial.trial) for trial in recording.trials] == [
        (user, str(trial)) for user, trial in TRIALS
    ]
    for index, samples in enumerate(TRIALS.values()):
        rows = recording.rows(index)
        np.testing.assert_allclose(rows.table[:, :3] * [1000, 1, 1], samples, atol=1e-9)


def test_a_mouse_stream_of_xdf_on_the_clock_of_the_recorder(tmp_path: Path) -> None:
    for offset in (None, 5.0):
        path = tmp_path / "own.xdf"
        write_xdf(path, offset)
        table = xdf.read(path)
        np.testing.assert_allclose(
            table.columns["time_stamps"], 100 + (offset or 0.0) + np.arange(48) * 0.008, atol=1e-9
        )
    (recording,) = read_any(path)
    assert [trial.trial for trial in recording.trials] == ["11", "12", "21", "22"]
    np.testing.assert_allclose(recording.events.table[:, 1], X)
    np.testing.assert_allclose(recording.events.table[:, 2], Y)
    np.testing.assert_allclose(recording.rows(0).t, np.arange(12) * 0.008, atol=1e-9)
    assert any("Amplifier" in note for note in recording.notes)


def test_pandas_reads_the_same_cells_of_a_sheet(tmp_path: Path) -> None:
    write_workbook(tmp_path / "own.xlsx")
    frame = pd.read_excel(tmp_path / "own.xlsx", sheet_name="mouse")
    assert frame.to_dict("list") == workbook.read(tmp_path / "own.xlsx").columns


def test_a_workbook_is_known_by_its_content(tmp_path: Path) -> None:
    write_workbook(tmp_path / "own.xlsx")
    (tmp_path / "own.xlsx").rename(tmp_path / "export")
    assert read_any(tmp_path / "export")[0].trials


@pytest.mark.parametrize("extension", ["xlsx", "xdf"])
def test_without_the_library_the_command_that_installs_it(
    extension: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    WRITERS[extension](tmp_path / f"own.{extension}")
    WRITERS["json"](tmp_path / "own.json")
    monkeypatch.setattr(extras, "find_spec", lambda name: None)
    with pytest.raises(MissingExtraError) as caught:
        read_any(tmp_path / f"own.{extension}")
    assert extras.install_command("tables") in str(caught.value)
    (recording,) = read_any(tmp_path)  # the rest of a folder is read
    assert [skip.trial for skip in recording.skipped] == [f"own.{extension}"]


def test_sheets_are_named_and_titles_above_the_table_left_out(tmp_path: Path) -> None:
    path = tmp_path / "own.xlsx"
    book = Workbook()
    for title, rows in {
        "few": [["a", "b"], [1, 2]],
        "first": [["Our study"], [], ["t", "x", "y", "x"], [0, 1, 2, None], [], [8, 3, None, 4, "more"]],
        "bare": [[0, 1, 2], [8, 3, 4]],
    }.items():
        sheet = book.create_sheet(title)
        for row in rows:
            sheet.append(row)
    book.save(path)
    first = {"t": [0, 8], "x.1": [1, 3], "y": [2, None], "x.3": [None, 4], "4": [None, "more"]}
    assert workbook.read(path, Reading(columns={"x": "x.1"})).columns == first
    bare = Reading(columns={"t": 0, "x": 1, "y": 2})
    with pytest.raises(RecordingError, match=r"own\.xlsx: records lie at 'first' .*'bare'"):
        workbook.read(path, bare)
    del book["first"]
    book.save(path)
    assert workbook.read(path, bare).columns == {"0": [0, 8], "1": [1, 3], "2": [2, 4]}
    del book["bare"]
    book.save(path)
    with pytest.raises(RecordingError, match=r"own\.xlsx: no table of 3 columns .*Sheet, few"):
        workbook.read(path, bare)


def test_a_sheet_that_claims_a_huge_size_costs_nothing(tmp_path: Path) -> None:
    path = tmp_path / "far.xlsx"
    book = Workbook()
    for column, name in enumerate(("t", "x", "y"), 1):
        book.active.cell(1, column, name)
    book.active.cell(100_000, 16_000, 7)
    book.save(path)
    table = workbook.read(path)
    assert table.columns == {"t": [None], "x": [None], "y": [None], "15999": [7]}


@pytest.mark.parametrize(
    ("variables", "expected"),
    [
        ({"t": T, "x": X, "y": Y, "fs": 125}, {"t": T, "x": X, "y": Y, "fs": [125] * len(T)}),
        ({"track": np.column_stack([T, X, Y])}, {"0": T, "1": X, "2": Y}),
        ({"track": np.vstack([T, X, Y])}, {"0": T, "1": X, "2": Y}),
        ({"t": T[:, None], "pos": np.column_stack([X, Y])}, {"t": T, "pos.0": X, "pos.1": Y}),
        (
            {"a": {"mouse": {"t": T, "x": X, "y": Y}, "user": "p"}},
            {"t": T, "x": X, "y": Y, "user": ["p"] * 48},
        ),
    ],
)
def test_arrangements_of_matlab(variables: dict, expected: dict, tmp_path: Path) -> None:
    savemat(tmp_path / "own.mat", variables)
    found = matlab.read(tmp_path / "own.mat").columns
    assert {name: list(cells) for name, cells in expected.items()} == found


def simplified(value: Any) -> Any:
    """scipy's values as Python's."""
    if isinstance(value, dict):
        return {name: simplified(inner) for name, inner in value.items()}
    if (isinstance(value, np.ndarray) and value.dtype == object) or isinstance(value, list):
        return [simplified(inner) for inner in value]
    return value.tolist() if isinstance(value, np.ndarray | np.generic) else value


@pytest.mark.parametrize("compressed", [False, True])
def test_values_are_those_that_scipy_reads(compressed: bool, tmp_path: Path) -> None:
    cells = np.empty((2, 3), object)
    cells[:] = [[T, "abc", 1.5], [X[:4], np.array([True, False]), np.eye(2)]]
    variables = {
        "whole": np.arange(-3, 4, dtype=np.int16),
        "wide": np.arange(24, dtype=np.uint64).reshape(2, 3, 4),
        "single": np.float32([0.1, 0.2]),
        "cells": cells,
        "word": "Zürich",
        "lines": np.array(["ab", "cde"]),
        "nested": {"a": {"b": {"c": [1, 2, 3]}}, "yes": True},
        "several": [{"t": T, "n": 1}, {"t": Y, "n": 2}],
        "number": 3.25,
    }
    savemat(tmp_path / "own.mat", variables, do_compression=compressed)
    loaded = loadmat(tmp_path / "own.mat", simplify_cells=True)
    found = matlab.variables_of((tmp_path / "own.mat").read_bytes())
    assert found == {name: simplified(loaded[name]) for name in variables} | {"lines": ["ab", "cde"]}
    assert found["nested"]["yes"] is True


def test_a_matlab_file_of_the_other_byte_order(tmp_path: Path) -> None:
    """One vector as a machine with the largest byte first writes it."""
    head = b"MATLAB 5.0 MAT-file".ljust(124) + b"\x01\x00MI"
    parts = [
        struct.pack(">IIII", 6, 8, 6, 0),
        struct.pack(">IIii", 5, 8, 1, 3),
        struct.pack(">HHb3x", 1, 1, 116),
    ]
    parts.append(struct.pack(">II3d", 9, 24, 1.5, 2.5, 3.5))
    assert matlab.variables_of(head + struct.pack(">II", 14, sum(map(len, parts))) + b"".join(parts)) == {
        "t": [1.5, 2.5, 3.5]
    }


def test_structures_and_cells_of_matlab_are_a_row_a_trial(tmp_path: Path) -> None:
    trials = [{"t": T[:12], "x": X[:12], "y": Y[:12], "id": 1}, {"t": T[:7], "x": X[:7], "y": Y[:7], "id": 2}]
    savemat(tmp_path / "own.mat", {"block": {"trials": trials, "user": "p"}})
    table = matlab.read(tmp_path / "own.mat").columns
    assert table["x"] == [X[:12].tolist(), X[:7].tolist()]
    assert (table["id"], table["user"]) == ([1, 2], ["p", "p"])
    cells = np.empty(2, object)
    cells[0], cells[1] = np.column_stack([T, X, Y]), np.column_stack([T, X, Y])[:5]
    savemat(tmp_path / "own.mat", {"track": cells})
    table = matlab.read(tmp_path / "own.mat").columns
    assert (table["1"], table["trial"]) == ([*X, *X[:5]], [0] * 48 + [1] * 5)


def test_objects_of_matlab_are_named(tmp_path: Path) -> None:
    savemat(tmp_path / "own.mat", {"t": T, "x": X, "y": Y, "z": T * 1j})
    assert any("complex: z" in note for note in matlab.read(tmp_path / "own.mat").notes)
    savemat(tmp_path / "own.mat", {"z": T * 1j})
    with pytest.raises(RecordingError, match="complex: z"):
        matlab.read(tmp_path / "own.mat")


def test_a_string_object_beside_vectors_is_left_aside(tmp_path: Path) -> None:
    """What MATLAB's own ``s = "ab"`` is saved as has no dimensions, unlike every other array."""
    savemat(tmp_path / "own.mat", {"t": T, "x": X, "y": Y})
    content = struct.pack("<IIII", 6, 8, 17, 0)
    for word in (b"s", b"MCOS", b"string"):
        content += struct.pack("<II", 1, len(word)) + word.ljust(8, b"\0")
    with (tmp_path / "own.mat").open("ab") as file:
        file.write(struct.pack("<II", 14, len(content)) + content)
    table = matlab.read(tmp_path / "own.mat")
    assert table.columns["x"] == X.tolist()
    assert any("strings) or complex: s" in note for note in table.notes)


def test_damaged_matlab_files_are_refused_or_read(tmp_path: Path) -> None:
    cells = np.empty(2, object)
    cells[:] = [T, "abc"]
    savemat(
        tmp_path / "own.mat", {"t": T[:6], "s": {"a": X[:6], "b": "hello"}, "c": cells, "r": [{"t": 1}] * 2}
    )
    data = (tmp_path / "own.mat").read_bytes()
    chance = np.random.default_rng(5)
    refused = 0
    for _ in range(2000):
        damaged = bytearray(data)
        for _ in range(3):
            damaged[chance.integers(124, len(data))] = chance.choice([0, 1, 4, 127, 255])
        try:
            matlab.variables_of(bytes(damaged[: chance.integers(0, 2 * len(data))]))
        except RecordingError:
            refused += 1
    assert 1000 < refused < 2000


@pytest.mark.parametrize("shape", [(20_000_000, 0), (0, 20_000_000), (5_000, 5_000), (-1, 1)])
@pytest.mark.parametrize("content", [b"", bytes(8)])
@pytest.mark.parametrize("kind", [1, 2, 4, 6])
def test_claims_of_size_in_matlab_are_not_believed(shape: tuple[int, int], content: bytes, kind: int) -> None:
    """Whatever a small file says of its arrays, little comes out of it; a structure here has no fields."""
    data = struct.pack("<II", {2: 1}.get(kind, 4), len(content)) + content
    parts = [
        struct.pack("<IIII", 6, 8, kind, 0),
        struct.pack("<IIii", 5, 8, *shape),
        struct.pack("<HHb3x", 1, 1, 116),
        *([struct.pack("<HHi", 5, 4, 32)] if kind == 2 else []),
        data,
    ]
    head = b"MATLAB 5.0 MAT-file".ljust(124) + b"\x00\x01IM" + struct.pack("<II", 14, sum(map(len, parts)))
    try:
        value = matlab.variables_of(head + b"".join(parts))["t"]
    except RecordingError:
        value = []
    assert len(value) <= 8


def test_matlab_files_that_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "own.mat"
    path.write_bytes(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(512) + b"\x89HDF\r\n\x1a\n")
    with pytest.raises(RecordingError, match="-v7"):
        read_any(path)
    monkeypatch.setattr(matlab, "MOST_UNPACKED", 1 << 20)
    savemat(path, {"t": np.zeros(1 << 18)}, do_compression=True)  # 2 MiB in 2 KiB
    with pytest.raises(RecordingError, match="bytes of values"):
        read_any(path)


def streams(path: Path, *parts: bytes) -> Path:
    path.write_bytes(b"XDF:" + b"".join(parts))
    return path


def test_the_stream_of_xdf_is_chosen_by_type_or_labels(tmp_path: Path) -> None:
    rows = [(float(at), 2.0) for at in range(4)]
    parts = [
        stream_header(1, "Left", "Position", ["x", "y"]),
        stream_header(2, "Right", "Position", ["x", "y"]),
        stream_header(3, "Keys", "Markers", ["key"], "string"),
        stream_header(4, "Gaze", "Eyes", ["gx", "gy"]),
        *(stream_samples(number, [1.0, 1.1, 1.2, 1.3], rows) for number in (1, 2, 4)),
    ]
    path = streams(tmp_path / "two.xdf", *parts)
    with pytest.raises(RecordingError, match=r"--columns.*Left \(type Position, 2 channels\): x, y; Right"):
        xdf.read(path)
    assert xdf.read(path, Reading(columns={"x": "gx", "y": "gy"})).notes[0].startswith("stream Gaze")
    for wanted in ("key", "x", "z"):
        with pytest.raises(RecordingError, match="--columns"):
            xdf.read(path, Reading(columns={"x": wanted}))
    path = streams(tmp_path / "one.xdf", parts[0], parts[2], parts[4])
    assert xdf.read(path).columns["x"].tolist() == [0, 1, 2, 3]


def test_a_cut_xdf_keeps_its_whole_chunks(tmp_path: Path) -> None:
    path = tmp_path / "own.xdf"
    write_xdf(path)
    whole = path.read_bytes()
    path.write_bytes(whole[:-100])
    table = xdf.read(path)
    assert len(table.columns["x"]) == 36
    assert any("left aside from there" in note for note in table.notes)
    with pytest.raises(RecordingError, match="no samples"):
        xdf.read(streams(path, stream_header(1, "Mouse", "Mouse", ["x", "y"])))


@pytest.mark.parametrize(
    ("write", "reader"), [(write_xdf, "pyxdf.load_xdf"), (write_workbook, "openpyxl.load_workbook")]
)
def test_a_file_for_which_memory_runs_out_is_not_called_damaged(
    write: Any, reader: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def exhausted(*arguments: Any, **options: Any) -> None:
        raise MemoryError("no room for 1 TB")

    write(tmp_path / "recording")
    monkeypatch.setattr(reader, exhausted)
    with pytest.raises(RecordingError, match=r"recording: needs more memory than there is.*1 TB"):
        read_any(tmp_path / "recording")


def test_claims_of_size_in_xdf_are_not_believed(tmp_path: Path) -> None:
    huge = stream_header(1, "Mouse", "Mouse", ["x", "y"]).replace(b"count>2<", b"count>99999999<")
    with pytest.raises(RecordingError, match="at most"):
        xdf.read(streams(tmp_path / "a.xdf", chunk(2, huge[7:])))
    header = stream_header(1, "Mouse", "Mouse", ["x", "y"])
    samples = chunk(3, b"\x01\0\0\0" + b"\x08" + (1 << 60).to_bytes(8, "little"))
    with pytest.raises(RecordingError, match="no samples"):
        xdf.read(streams(tmp_path / "b.xdf", header, clock_offset(1, 1.0, 0.0), samples))


@pytest.mark.parametrize(
    ("head", "word"),
    [
        (b"RDX3\nX\n", "write.csv"),
        (gzip.compress(b"X\n\0\0\0\3" + bytes(99), mtime=0), "write.csv"),
        (b"$FL2@(#)", "CSV"),
        (b"PK\x03\x04", ""),
    ],
)
def test_files_of_other_programs_are_refused(head: bytes, word: str, tmp_path: Path) -> None:
    path = tmp_path / "own.data"
    path.write_bytes(head)
    with pytest.raises(RecordingError) as caught:
        read_any(path)
    assert word in str(caught.value)
