"""Files and strings of another version are refused as docs/reference/compatibility.md says, never misread."""

from __future__ import annotations

import base64
from pathlib import Path

import numpy as np
import pytest

from pointpred import build
from pointpred.errors import ParameterError, RecordingError
from pointpred.predictors.kinematic import coefficient_file
from pointpred.recordings.own import read
from tests.golden.exchanges import FOLDER, persons

ROW = "user,trial,t_s,x_px,y_px,dx_counts,dy_counts,buttons\np,1,0.0,1.0,2.0,,,0\np,1,0.1,2.0,2.0,,,0\n"


def recording(folder: Path, version: object) -> Path:
    path = folder / "one_samples.csv"
    path.write_text(f'# pointpred:{{"version": {version}, "name": "one"}}\n{ROW}')
    return path


def test_a_recording_of_version_1_is_read_and_of_another_refused(tmp_path: Path) -> None:
    assert len(read(recording(tmp_path, 1)).trials) == 1
    for version in (0, 2, '"1"', "null"):
        with pytest.raises(RecordingError, match=r"header version .*, expected 1") as caught:
            read(recording(tmp_path, version))
        assert caught.value.code == "bad_recording"


def test_a_person_of_another_version_or_layout_is_refused() -> None:
    (person,) = persons(FOLDER / "learned.jsonl")
    assert build("kinematic-adaptive", person=person).person == person
    body = bytearray(base64.urlsafe_b64decode(person[2:] + "=" * (-len(person[2:]) % 4)))
    body[0] ^= 1  # the name of the layout begins the string
    other = "1." + base64.urlsafe_b64encode(bytes(body)).decode().rstrip("=")
    for refused, reason in (
        ("2" + person[1:], "must begin with '1.'"),
        (other, "another version of this one"),
    ):
        with pytest.raises(ParameterError, match=reason) as caught:
            build("kinematic-adaptive", person=refused)
        assert (caught.value.code, caught.value.field) == ("bad_parameter", "person")


@pytest.mark.parametrize("version", [1, coefficient_file.VERSION + 1])
def test_coefficients_of_another_version_are_refused(version: int, tmp_path: Path) -> None:
    with np.load(coefficient_file.OWN) as file:
        arrays = dict(file)
    path = tmp_path / "other.npz"
    np.savez(path, **arrays)
    coefficient_file.read(path)
    np.savez(path, **(arrays | {"version": np.int64(version)}))
    with pytest.raises(
        ParameterError, match=f"must be a file of version 2: .*is of version {version}"
    ) as caught:
        coefficient_file.read(path)
    assert caught.value.code == "bad_parameter"
