"""What the distribution promises beside its code: one version with the library, and the names of before."""

from __future__ import annotations

import tomllib
from importlib import import_module
from pathlib import Path

import pytest

import pointpred_observers
from pointpred import extras
from pointpred.errors import MissingExtraError

FOLDER = Path(__file__).parents[1]


def version(file: Path) -> str:
    return str(tomllib.loads(file.read_text(encoding="utf-8"))["project"]["version"])


def test_it_has_the_version_of_the_library() -> None:
    assert version(FOLDER / "pyproject.toml") == version(FOLDER.parent / "pyproject.toml")


@pytest.mark.parametrize(
    ("old", "new", "name"),
    [
        ("pointpred.observers", "pointpred_observers", "Persidskii"),
        ("pointpred.observers.examples", "pointpred_observers.examples", "two_masses"),
        ("pointpred.camera", "pointpred_observers.camera", "DepthObserver"),
    ],
)
def test_the_names_of_version_0_1_load_with_a_warning(old: str, new: str, name: str) -> None:
    with pytest.warns(DeprecationWarning, match=f"is {new.removesuffix('.examples')} now"):
        exec(f"from {old} import {name}")
    assert hasattr(import_module(new), name)


def test_the_old_name_gives_the_same_things() -> None:
    from pointpred import observers

    with pytest.warns(DeprecationWarning, match="is pointpred_observers now"):
        assert observers.Persidskii is pointpred_observers.Persidskii


@pytest.mark.parametrize("old", ["observers", "camera"])
def test_without_the_distribution_the_old_name_says_what_to_install(
    old: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pointpred.extras.find_spec", lambda name: None)
    with pytest.raises(MissingExtraError) as refused:
        exec(f"from pointpred.{old} import simulate")
    assert str(refused.value).endswith(extras.install_command(of="pointpred-observers"))
