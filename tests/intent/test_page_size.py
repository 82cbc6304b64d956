"""What a page loads stays small, as stock bundlers make it, and predicts soon."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from evidence.costs import page_size
from tests.server import browser

pytestmark = [browser.needed, pytest.mark.slow]  # bundlers of npm: `make npm` runs it

SMALL = 15_000
"""What `onIntent` may take with a small predictor: bytes, compressed."""
LEARNED = 60_000
"""Everything with the learned predictor."""
REQUESTS = {
    "minimum-jerk": {"esbuild": 1, "vite": 1, "rollup": 1},
    "kinematic-adaptive": {"esbuild": 6, "vite": 3, "rollup": 3},
    "intent": {"esbuild": 21, "vite": 5, "rollup": 5},
}
"""As the guide and the page of costs have them; esbuild splits chunks of a few lines off."""
SOON_S = 0.6


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    try:
        return page_size.project(tmp_path_factory.mktemp("sizes"))
    except page_size.NpmMissingError as missing:
        pytest.skip(str(missing))


@pytest.fixture(scope="module")
def load(tmp_path_factory: pytest.TempPathFactory) -> Iterator[page_size.Load]:
    with page_size.chromium(tmp_path_factory.mktemp("profile")) as load:
        yield load


@pytest.mark.parametrize("bundler", page_size.COMMANDS)
@pytest.mark.parametrize("entry", REQUESTS)
def test_what_a_bundler_makes_is_small(project: Path, load: page_size.Load, entry: str, bundler: str) -> None:
    loaded = load(page_size.bundle(project, page_size.SUBJECTS[f"`pointpred/{entry}`"], bundler))
    assert loaded.first_s is not None, "it predicts"
    assert loaded.size <= (SMALL if entry == "minimum-jerk" else LEARNED)
    assert loaded.requests <= REQUESTS[entry][bundler]


def test_the_script_for_a_tag_predicts_soon_from_a_slow_host(project: Path, load: page_size.Load) -> None:
    """The best of some visits: a machine that others keep busy may be late."""
    for script in page_size.SCRIPTS:
        made = page_size.script_tag(project, script)
        visits = [load(made, page_size.LATENCY_S, still_s=1.5) for _ in range(5)]
        assert {one.requests for one in visits} == {1}
        assert min(one.first_s or 9.0 for one in visits) <= SOON_S
