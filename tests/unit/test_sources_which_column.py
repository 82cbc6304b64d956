"""Tables of which the names, or their lack, leave open which column is which."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from pointpred.errors import ColumnsError
from pointpred.recordings import read_any
from tests.building import lines_file


def write(folder: Path, rows: Sequence[Sequence[object]], header: str = "") -> Path:
    """A table of these rows, with a header where there is one."""
    lines = [",".join(str(cell) for cell in row) for row in rows]
    return lines_file(folder / "which.csv", *([header] if header else []), *lines)


def test_columns_of_one_name_are_refused(tmp_path: Path) -> None:
    path = write(tmp_path, [(20 * i, i, 2 * i, 500 + i, 90 - i) for i in range(20)], "t,x,y,x,y")
    with pytest.raises(ColumnsError) as refusal:
        read_any(path)
    assert refusal.value.reason == "x may be x.1 or x.3; y may be y.2 or y.4"
    assert "--columns t=t,x=x.1,y=y.2 --time-unit ms" in str(refusal.value)
    [recording] = read_any(path, columns={"x": 3, "y": 4}, time_unit="ms")
    assert recording.events.x[0] == 500


def test_users_of_one_name_that_are_the_same_are_one(tmp_path: Path) -> None:
    path = write(tmp_path, [(20 * i, i, 2 * i, "a", "a") for i in range(20)], "t,x,y,user,user")
    [recording] = read_any(path)
    assert recording.trials[0].user == "a"


@pytest.mark.parametrize(
    ("rows", "pairs"),
    [
        ([(20 * i, i % 5, -i) for i in range(20)], "t=0,x=1,y=2 --time-unit ms"),
        ([(i % 5, -i, 0.02 * i) for i in range(20)], "t=2,x=0,y=1 --time-unit s"),
        ([("move", 1 + i // 10, 20 * i, i % 5, -i) for i in range(20)], "t=2,x=3,y=4 --time-unit ms"),
        ([(i, 20 * i, i % 5, -i) for i in range(20)], "t=1,x=2,y=3 --time-unit ms"),
        ([(20 * i, "move", i % 5, -i) for i in range(20)], "t=0,x=COLUMN,y=COLUMN --time-unit ms"),
        ([(20 * i, 3 * i, 5 * i) for i in range(20)], "t=COLUMN,x=COLUMN,y=COLUMN"),
        ([(i % 7, i % 5, -i) for i in range(20)], "t=COLUMN,x=COLUMN,y=COLUMN"),
    ],
    ids=[
        "first",
        "last",
        "behind words and trials",
        "behind the number of the row",
        "words after it",
        "all may be",
        "none is",
    ],
)
def test_without_a_header_the_clock_is_what_never_goes_backwards(
    tmp_path: Path, rows: list[tuple[object, ...]], pairs: str
) -> None:
    with pytest.raises(ColumnsError) as refusal:
        read_any(write(tmp_path, rows))
    assert str(refusal.value).endswith(f"--columns {pairs}")
