"""Files of coefficients: what is written packs well, and what cannot be right is refused with a reason."""

from __future__ import annotations

import gzip
import os
import zipfile
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest

from pointpred import build
from pointpred.errors import ParameterError
from pointpred.predictors import KinematicPredictor
from pointpred.predictors.kinematic import coefficient_file as coefficients
from pointpred.predictors.kinematic import features, network


def own() -> dict[str, Any]:
    with np.load(coefficients.OWN) as file:
        return {name: np.asarray(file[name]) for name in file.files}


def wrong(path: Path, **changes: Any) -> Path:
    np.savez(path, **{name: array for name, array in (own() | changes).items() if array is not None})
    return path


def wide(first: int, second: int) -> dict[str, Any]:
    return {
        "weights0": np.zeros((features.Values.length, first), np.float32),
        "offset0": np.zeros(first, np.float32),
        "weights1": np.zeros((first, second), np.float32),
        "offset1": np.zeros(second, np.float32),
        "weights2": np.zeros((second, 12), np.float32),
    }


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"version": np.int64(1)}, "is of version 1"),
        ({"mean": None}, "mean"),
        ({"offset1": np.zeros(3)}, "offset1 must hold"),
        ({"version": np.float64(1.5)}, ""),
        ({"version": np.array([1, 1])}, ""),
        ({"version": np.array("1")}, ""),
        ({"mean": np.array(["a"] * features.Values.length)}, ""),
        ({"mean": np.ones(features.Values.length, complex)}, ""),
        ({"mean": np.ones(features.Values.length, object)}, ""),
        ({"weights0": np.ones(features.Values.length)}, ""),
        ({"weights1": np.float64(1.0)}, ""),
        ({"table": np.full((10, 3), 1e3)}, ""),
        ({"offset2": np.full(12, 2e4)}, ""),
        ({"scale": np.full(features.Values.length, 1e7)}, ""),
        (wide(0, 4), ""),
        (wide(4, 0), ""),
        (wide(1025, 4), ""),
    ],
)
def test_arrays_that_do_not_fit_are_refused(tmp_path: Path, changes: dict[str, Any], words: str) -> None:
    with pytest.raises(ParameterError, match=f"coefficients must be a file of version 2.*{words}"):
        coefficients.read(wrong(tmp_path / "wrong.npz", **changes))


@pytest.mark.parametrize("value", [0.0, -1.0, np.nan, np.inf])
def test_scales_are_above_zero_and_finite(tmp_path: Path, value: float) -> None:
    scale = own()["scale"].copy()
    scale[3] = value
    with pytest.raises(ParameterError, match=f"scale must hold numbers .*, holds {value:g}"):
        build("kinematic", coefficients=wrong(tmp_path / "wrong.npz", scale=scale))


def test_where_nothing_can_be_written_is_said_before(tmp_path: Path) -> None:
    (tmp_path / "folder.npz").mkdir()
    (tmp_path / "file").write_text("")
    for path in (tmp_path / "no" / "me.npz", tmp_path / "folder.npz", tmp_path / "file" / "me.npz"):
        with pytest.raises(ParameterError, match="cannot write"):
            coefficients.check_writable(path)
    coefficients.check_writable(tmp_path / "me.npz")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file", "folder.npz"]


def test_hidden_layers_of_one_and_of_many_are_taken(tmp_path: Path) -> None:
    for first, second in ((1, 1), (1024, 4)):
        flat = coefficients.read(wrong(tmp_path / f"{first}.npz", **wide(first, second)))
        assert flat[:2].tolist() == [first, second]


def test_a_damaged_file_is_refused_or_read_as_it_was(tmp_path: Path) -> None:
    whole, path = coefficients.OWN.read_bytes(), tmp_path / "damaged.npz"
    generator, kept, refused = np.random.default_rng(3), coefficients.read(coefficients.OWN), 0
    places = [*generator.integers(0, len(whole), 60), *range(60), *range(len(whole) - 200, len(whole))]
    for place in places:
        damaged = bytearray(whole)
        damaged[place] ^= int(generator.integers(1, 256))
        path.write_bytes(damaged)
        try:
            assert np.array_equal(coefficients.read(path), kept)
        except ParameterError:
            refused += 1
    assert refused > 60  # a flipped byte of a date or of the card's own text harms nobody
    for length in (0, 1, 30, 1000, len(whole) // 2, len(whole) - 1):
        path.write_bytes(whole[:length])
        with pytest.raises(ParameterError):
            coefficients.read(path)


def test_an_array_whose_header_is_no_python_is_refused(tmp_path: Path) -> None:
    header = b"{'descr': '<f4', 'fortran_order': False, 'shape': (".ljust(117) + b"\n"
    with zipfile.ZipFile(tmp_path / "open.npz", "w") as archive:
        archive.writestr("mean.npy", b"\x93NUMPY\x01\x00" + len(header).to_bytes(2, "little") + header)
    with pytest.raises(ParameterError, match=r"open\.npz"):
        coefficients.read(tmp_path / "open.npz")


def test_another_kind_of_file_is_refused(tmp_path: Path) -> None:
    np.save(tmp_path / "plain.npy", np.ones(3))
    (tmp_path / "text.npz").write_text("no archive")
    for path in (tmp_path / "plain.npy", tmp_path / "text.npz", tmp_path, tmp_path / "none.npz"):
        with pytest.raises(ParameterError, match="coefficients must be a file of version 2"):
            coefficients.read(path)
    for other in (None, 3):
        with pytest.raises(ParameterError, match="path"):
            coefficients.read(cast(Any, other))


def test_what_would_fill_the_memory_is_refused_before_it_is_inflated(tmp_path: Path) -> None:
    np.savez_compressed(tmp_path / "zeros.npz", **(own() | {"more": np.zeros(1 << 25, np.uint8)}))
    assert (tmp_path / "zeros.npz").stat().st_size < coefficients.LARGEST_BYTES
    with pytest.raises(ParameterError, match="inflate"):
        coefficients.read(tmp_path / "zeros.npz")
    lies = tmp_path / "lies.npz"
    wrong(lies)
    with zipfile.ZipFile(lies, "a") as file, file.open("more.npy", "w") as member:
        header = {"descr": "<f8", "fortran_order": False, "shape": (1 << 50,)}
        np.lib.format.write_array_header_1_0(member, header)
    with pytest.raises(ParameterError, match="more"):
        coefficients.read(lies)


def test_a_path_may_be_text_and_a_file_written_anew_is_read_anew(tmp_path: Path) -> None:
    path = wrong(tmp_path / "same.npz")
    before = coefficients.read(str(path))
    assert coefficients.read(path) is coefficients.read(path)
    assert not before.flags.writeable
    wrong(path, mean=own()["mean"] + 1.0)
    os.utime(path, ns=(0, 1))
    assert coefficients.read(path)[2] == before[2] + 1.0


def test_the_digest_is_of_the_numbers_and_not_of_their_packing(tmp_path: Path) -> None:
    packed, changed = tmp_path / "packed.npz", own()
    np.savez_compressed(packed, **own())
    assert packed.read_bytes() != coefficients.OWN.read_bytes()
    assert coefficients.digest(packed) == coefficients.digest(coefficients.OWN)
    changed["mean"] = np.nextafter(changed["mean"], np.inf)
    assert coefficients.digest(wrong(tmp_path / "changed.npz", **changed)) != coefficients.digest(packed)


@pytest.mark.parametrize(
    "card", [b"", b"[]", b"{", b'{"sets": [{}]}', b'{"sets": [{"name": 3}]}', b'{"sets": 3}', b"\xff\xfe"]
)
def test_a_card_that_is_none_is_refused_with_the_file_named(tmp_path: Path, card: bytes) -> None:
    path = wrong(tmp_path / "odd.npz", card=np.frombuffer(card, np.uint8))
    with pytest.raises(ParameterError, match="odd"):
        KinematicPredictor(coefficients=path)


def test_the_coefficients_of_the_package_pack_into_20_kilobytes() -> None:
    packed = gzip.compress(coefficients.read(coefficients.OWN).astype("<f4").tobytes(), 9)
    assert len(packed) < 20_000


def test_what_is_written_is_single_precision_near_what_was_given(tmp_path: Path) -> None:
    random, arrays = np.random.default_rng(3), own()
    changed = {
        name: array * random.uniform(0.5, 0.9, array.shape)
        for name, array in arrays.items()
        if array.dtype.kind == "f"
    }
    layers = [(changed[f"weights{number}"], changed[f"offset{number}"]) for number in range(3)]
    path = tmp_path / "me.npz"
    coefficients.write(path, changed["mean"], changed["scale"], layers, changed["table"], {})
    given, flat = coefficients.read(wrong(tmp_path / "exact.npz", **changed)), coefficients.read(path)
    np.testing.assert_allclose(flat, given, rtol=2.0**-10)
    assert not np.array_equal(flat, given)
    assert np.array_equal(flat, flat.astype(np.float32))
    behind = (1 << 23 - coefficients.MANTISSA_BITS) - 1
    assert not (flat.astype(np.float32).view(np.uint32) & behind).any()
    assert np.array_equal(coefficients.short(flat), flat)


def test_the_first_weights_stand_where_a_line_of_the_cache_begins(tmp_path: Path) -> None:
    for number in range(4):  # an allocation may happen to be right
        flat = coefficients.read(wrong(tmp_path / f"{number}.npz"))
        weights = flat[network.Coefficients.length :]
        assert weights[0] == np.float64(own()["weights0"][0, 0])
        assert weights.ctypes.data % 64 == 0
