"""``evidence.inputs.measure`` accounts for every row of a file, and says what differs."""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

import pytest

from evidence.data import Tables, read
from evidence.inputs import measure as inputs
from evidence.inputs.independent import delimited
from evidence.inputs.measure import account
from pointpred.recordings import read_any
from tests.fuzz import inputs as inputs_fuzz

ROWS = ["ms,px,py,who,n"]
ROWS += [f"{10 * i},{3 * i},{i % 4},anna,one" for i in range(6)]
ROWS += [f"{10 * i},{5},{5},anna,still" for i in range(4)]
ROWS += [f"{10 * i},{i},{i},anna," for i in range(2)]
STREAM = ["t;x;y", *(f"{20 * i};{7 * i};0" for i in range(8)), *(f"{900 + 20 * i};{i};0" for i in range(5))]
ARGUMENTS: dict[str, Any] = {"t": "ms", "x": "px", "y": "py", "user": "who", "trial": "n", "per_second": 1000}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Two files where the list expects them."""
    for name, lines in (("anna/own+data/a.csv", ROWS), ("anna/own+stream/s.csv", STREAM)):
        path = tmp_path / name
        path.parent.mkdir(parents=True)
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return tmp_path / "anna"


def write_list(folder: Path, *, sha256: str | None = None) -> Path:
    """The list of the two files."""
    first, second = folder / "own+data/a.csv", folder / "own+stream/s.csv"
    digests = [hashlib.sha256(path.read_bytes()).hexdigest() for path in (first, second)]
    arguments = ", ".join(f'{key} = "{value}"' for key, value in ARGUMENTS.items() if key != "per_second")
    text = (
        '[[file]]\nrepository = "own/data"\ncommit = "1"\npath = "a.csv"\n'
        f'sha256 = "{sha256 or digests[0]}"\nlicence = "none"\nwhat = "keys"\n'
        f'layout = "delimited"\narguments = {{ {arguments}, per_second = 1000 }}\n'
        'options.columns = { t = "ms", x = "px", y = "py", user = "who", trial = "n" }\n'
        f'[[file]]\nrepository = "own/stream"\ncommit = "1"\npath = "s.csv"\nsha256 = "{digests[1]}"\n'
        'licence = "none"\nwhat = "a stream"\nlayout = "delimited"\n'
        'arguments = { sep = ";", t = "t", x = "x", y = "y", per_second = 1000, cut = "bursts" }\n'
        'options.cut = "bursts"\n'
    )
    path = folder / "list.toml"
    path.write_text(text, encoding="utf-8")
    return path


def run(folder: Path, listed: Path, *more: str) -> tuple[Tables | None, int]:
    """The numbers that the command keeps, and its exit status."""
    out = folder / "data.json"
    with pytest.raises(SystemExit) as ended:
        inputs.main([str(folder), "--list", str(listed), "--out", str(out), *more])
    code = ended.value.code
    return read(out, Tables) if out.exists() else None, code if isinstance(code, int) else 2


def test_every_row_is_read_or_left_out_with_its_reason(folder: Path) -> None:
    kept, code = run(folder, write_list(folder))
    assert code == 0
    assert kept is not None
    rows = kept.tables["files"].texts()
    assert [row[2] for row in rows] == [
        "`--columns t=ms,x=px,y=py,user=who,trial=n`",
        "`--cut bursts`",
    ]
    assert [row[3:5] for row in rows] == [["1", "6"], ["2", "13"]]
    assert rows[0][5].startswith("4 no movement")
    assert "; 2 rows without user or trial" in rows[0][5]
    totals = kept.numbers["totals"]
    assert [totals[key] for key in ("files", "sources", "read", "lost")] == [2, 2, 2, 0]


def test_a_row_that_no_reason_names_is_lost_and_a_value_that_differs_is_measured(folder: Path) -> None:
    path = folder / "own+data/a.csv"
    [recording] = read_any(path, inputs.reading_of(inputs.listed(write_list(folder))[0]))
    rows = delimited(path, **ARGUMENTS)
    assert account(rows, recording).agrees
    silent = account(
        rows, type(recording)(recording.name, recording.events, recording.offsets, recording.trials)
    )
    assert (silent.lost, silent.agrees) == (6, False)
    assert account(rows.drop(index=5), recording).lost == 1
    off = account(
        rows.assign(x=rows["x"] + 0.5 * (rows.index == 3), t=rows["t"] + 0.25 * (rows.index == 4)), recording
    )
    assert (off.px, round(off.s, 9), off.agrees) == (0.5, 0.25, False)


def test_missing_and_other_files_are_named_and_nothing_is_kept(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    listed = write_list(folder, sha256="0" * 64)
    (folder / "own+stream/s.csv").unlink()
    assert run(folder, listed) == (None, 2)
    said = capsys.readouterr().err
    assert "own+data" in said
    assert "own+stream" in said
    kept, _ = run(folder, listed, "--partial")
    assert kept is not None
    assert kept.numbers["totals"]["files"] == 0


@pytest.mark.parametrize(
    ("known", "wrong"),
    [
        ('x = "px", y = "py", user = "who", trial = "n" }\n[[', 'x = "none", y = "py" }\n[['),
        ('layout = "delimited"\narguments = { sep', 'refused = "it is none"\narguments = { sep'),
    ],
    ids=["refused without a reason", "read although none expects it"],
)
def test_what_the_list_does_not_expect_fails(folder: Path, known: str, wrong: str) -> None:
    listed = write_list(folder)
    text = listed.read_text(encoding="utf-8")
    assert known in text
    listed.write_text(text.replace(known, wrong), encoding="utf-8")
    kept, code = run(folder, listed)
    assert code == 1
    assert kept is not None
    assert [row[3] for row in kept.tables["files"].texts()].count("**not as expected**") == 1


def test_damaged_files_are_the_same_each_time_and_what_breaks_is_kept(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = inputs.listed(write_list(folder))[0]
    runs = [inputs_fuzz.fuzz(file, folder, 4, folder) for _ in range(2)]
    assert runs[0].ends == runs[1].ends
    assert not runs[0].broken
    assert runs[0].ends["read"] > 0 < runs[0].ends["refused"]

    def burst(*_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(inputs_fuzz, "read_any", burst)
    broken = inputs_fuzz.fuzz(file, folder, 2, folder).broken
    assert len(broken) == 2
    assert all("ZeroDivisionError" in line and Path(line.split(" (")[0]).exists() for line in broken)
