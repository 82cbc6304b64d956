"""The service of a study: what its links reach, what it refuses, and that other services have none of it."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import msgspec
import pytest
from httpx2 import Response, get, post

from pointpred.studies.folder import Participant, Study
from pointpred.studies.messages import MOST_BYTES, Agreed, Message
from tests.server.running import PATIENCE_S, Running, running
from tests.studied import PAGE, movement, study_in


@pytest.fixture
def study(tmp_path: Path) -> Study:
    return study_in(tmp_path)


@pytest.fixture
def served(study: Study) -> Iterator[Running]:
    with running(lambda service: setattr(service, "study", study), token="open sesame") as here:
        yield here


def send(url: str, message: Message | bytes, **headers: str) -> Response:
    body = message if isinstance(message, bytes) else msgspec.json.encode(message)
    return post(url, content=body, headers=headers, timeout=PATIENCE_S)


def test_a_link_reaches_its_participant_and_no_other(study: Study, served: Running) -> None:
    one, other = (study.participants[code] for code in ("P01", "P02"))
    urls = {code: f"{served.url}/v1/study/{link}" for code, link in study.links().items()}
    told: dict[str, Any] = get(urls["P01"], timeout=PATIENCE_S).json()
    assert (told["agreed"], told["stored"], told["next"]) == (False, 0, [1, 1])
    assert len(told["plan"]) == 4
    assert send(urls["P01"], movement(one)).status_code == 409
    assert not one.folder.exists()
    assert send(urls["P01"], Agreed(PAGE)).status_code == 200
    assert send(urls["P01"], movement(one)).json() == one.state() | {"next": [1, 2]}
    assert (len(one.done()), len(other.done())) == (1, 0)
    assert not other.folder.exists()
    assert "P02" not in get(urls["P01"], timeout=PATIENCE_S).text
    for wrong in ("P01", "x" * 22, "..%2FP01", "%C3%A9", ""):
        assert get(f"{served.url}/v1/study/{wrong}", timeout=PATIENCE_S).status_code == 404
        assert send(f"{served.url}/v1/study/{wrong}", Agreed(PAGE)).status_code in (404, 405)
    assert get(f"{served.url}/study/{study.links()['P01']}", timeout=PATIENCE_S).status_code == 200
    assert get(f"{served.url}/v1/predictors", timeout=PATIENCE_S).status_code == 401


def test_the_address_without_a_link_leads_to_the_studys_page(served: Running) -> None:
    page = get(f"{served.url}/", timeout=PATIENCE_S, follow_redirects=True)
    assert (page.status_code, str(page.url)) == (200, f"{served.url}/study/")
    assert "<title>Study</title>" in page.text
    told = get(f"{served.url}/v1/study/", timeout=PATIENCE_S)
    assert told.status_code == 404
    assert "link of their own" in told.json()["message"]


@pytest.mark.parametrize(
    "headers",
    [
        {"origin": "https://elsewhere.example"},
        {"sec-fetch-site": "cross-site"},
        {"host": "elsewhere.example"},
    ],
)
def test_pages_of_others_are_refused(study: Study, served: Running, headers: dict[str, str]) -> None:
    url = f"{served.url}/v1/study/{study.links()['P01']}"
    refused = send(url, Agreed(PAGE), **headers)
    assert refused.status_code == 403
    assert "--allow-origin" not in refused.text  # which a study has not
    assert not study.participants["P01"].folder.exists()


def test_bodies_are_bounded_and_checked(study: Study, served: Running) -> None:
    url = f"{served.url}/v1/study/{study.links()['P01']}"
    assert send(url, b" " * (MOST_BYTES + 1)).status_code == 413
    one: Participant = study.participants["P01"]
    good = msgspec.json.encode(movement(one))
    for body in (b"", b"\xff", b"[]", b'{"type":"other"}', good.replace(b'"clicks":1', b'"clicks":1e99')):
        assert send(url, body).json()["code"] == "bad_field"
    assert not one.folder.exists()


def test_participants_at_the_same_time_do_not_disturb_each_other(study: Study, served: Running) -> None:
    def part(code: str) -> list[int]:
        one, url = study.participants[code], f"{served.url}/v1/study/{study.links()[code]}"
        send(url, Agreed(PAGE))
        sent = [movement(one, i, t=1.0 + 2.0 * i) for i in range(9)]
        return [send(url, moved).json()["stored"] for moved in sent]

    codes = study.design.codes
    with ThreadPoolExecutor(len(codes)) as pool:
        assert list(pool.map(part, codes)) == [list(range(1, 10))] * len(codes)
    for code in codes:
        stored = [(done.sequence, done.movement) for done in study.participants[code].done()]
        assert stored == [(i // 3 + 1, i % 3 + 1) for i in range(9)]


def test_other_services_have_no_study(service: Running) -> None:
    assert get(f"{service.url}/study/x", timeout=PATIENCE_S).status_code == 404
    assert post(f"{service.url}/v1/study/x", content=b"", timeout=PATIENCE_S).status_code == 404


def test_a_full_disk_is_told_and_nothing_is_lost(
    study: Study, served: Running, monkeypatch: pytest.MonkeyPatch
) -> None:
    one = study.participants["P01"]
    url = f"{served.url}/v1/study/{study.links()['P01']}"
    send(url, Agreed(PAGE))
    sent = movement(one)
    with monkeypatch.context() as full:
        full.setattr("pointpred.studies.folder.trial_row", _full)
        assert send(url, sent).status_code == 507
    assert send(url, sent).json()["stored"] == 1
    assert [path.name for path in sorted(one.folder.glob("*_trials.csv"))] == ["P01-2_trials.csv"]


def _full(*_: object) -> bytes:
    raise OSError(28, "No space left on device")
