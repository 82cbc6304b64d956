"""The names of before: ``pointpred.observers`` and ``pointpred.camera`` load for one version more."""

from __future__ import annotations

import pytest

import pointpred_observers
from pointpred import extras
from pointpred.errors import MissingExtraError


def test_the_old_names_load_with_a_warning() -> None:
    with pytest.warns(DeprecationWarning, match="is pointpred_observers now"):
        from pointpred.observers import Persidskii
    assert Persidskii is pointpred_observers.Persidskii
    with pytest.warns(DeprecationWarning, match=r"is pointpred_observers\.camera now"):
        from pointpred.camera import DepthObserver
    assert DepthObserver.__module__ == "pointpred_observers.camera.depth"


@pytest.mark.parametrize("old", ["observers", "camera"])
def test_without_the_distribution_the_old_name_says_what_to_install(
    old: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pointpred.extras.find_spec", lambda name: None)
    with pytest.raises(MissingExtraError) as refused:
        exec(f"from pointpred.{old} import simulate")
    assert str(refused.value).endswith(extras.install_command(of="pointpred-observers"))
