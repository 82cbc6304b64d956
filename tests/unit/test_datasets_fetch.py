"""Fetching a public set, against a server on this machine's loopback."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler
from pathlib import Path
from urllib.parse import urljoin

import pytest

from pointpred.datasets import DataSet, RemoteFile, fetch, find, listing
from pointpred.datasets.fetch import check_url
from pointpred.errors import ParameterError, SourceError
from pointpred.recordings.known_formats import FORMATS
from tests.hosts import Silent, host

BODY = b"user,trial,t_s\n" * 9000
DIGEST = hashlib.sha256(BODY).hexdigest()


class Handler(Silent, BaseHTTPRequestHandler):
    def do_GET(self) -> None:
        if self.path == "/missing.csv":
            self.send_error(404)
            return
        if self.path == "/elsewhere.csv":
            self.send_response(302)
            self.send_header("Location", "http://example.org/moves.csv")
            self.end_headers()
            return
        self.send_response(200)
        if self.path == "/short.csv":
            self.send_header("Content-Length", str(len(BODY) + 10))
        elif self.path != "/endless.csv":
            self.send_header("Content-Length", str(len(BODY)))
        self.end_headers()
        self.wfile.write(BODY)


@pytest.fixture(scope="module")
def server() -> Iterator[str]:
    with host(Handler) as origin:
        yield origin


def entry(url: str, sha256: str | None = DIGEST) -> DataSet:
    file = RemoteFile("moves.csv", url, sha256)
    return DataSet("test", "Test", "https://example.org", "MIT", "Someone", 1, 1, "", "", files=(file,))


def test_a_file_arrives_whole_and_is_checked(server: str, tmp_path: Path) -> None:
    heard: list[str] = []
    steps: list[tuple[str, int, int | None]] = []
    (done,) = fetch(
        entry(f"{server}/moves.csv"),
        tmp_path / "new" / "folder",
        say=heard.append,
        progress=lambda *step: steps.append(step),
    )
    assert done.path.read_bytes() == BODY
    assert (done.sha256, done.size, done.verified) == (DIGEST, len(BODY), True)
    assert heard[0].startswith("test: MIT. Please cite Someone")
    assert [step[1] for step in steps] == sorted(step[1] for step in steps)
    assert len(steps) > 1
    assert steps[-1] == ("moves.csv", len(BODY), len(BODY))
    assert [path.name for path in done.path.parent.iterdir()] == ["moves.csv"]


@pytest.mark.parametrize(
    ("path", "sha256", "most", "says"),
    [
        ("moves.csv", "0" * 64, 10**6, f"expected sha256 {'0' * 64}, received {DIGEST}"),
        ("missing.csv", DIGEST, 10**6, "404"),
        ("short.csv", DIGEST, 10**6, "cut short"),
        ("moves.csv", DIGEST, 1000, "larger than the bound of 1000 bytes"),
        ("endless.csv", DIGEST, 70000, "larger than the bound of 70000 bytes"),
        ("http://127.0.0.1:9/moves.csv", DIGEST, 10**6, r"127\.0\.0\.1:9/"),
        ("elsewhere.csv", DIGEST, 10**6, r"only https.*example\.org"),
    ],
)
def test_what_is_wrong_leaves_nothing_behind(
    server: str, tmp_path: Path, path: str, sha256: str, most: int, says: str
) -> None:
    wanted = entry(urljoin(f"{server}/", path), sha256)
    with pytest.raises((SourceError, ParameterError), match=says):
        fetch(wanted, tmp_path, most_bytes=most, timeout_s=20.0, say=lambda _: None)
    assert not list(tmp_path.iterdir())


def test_an_unrecorded_digest_is_refused_before_anything_is_fetched(tmp_path: Path) -> None:
    with pytest.raises(ParameterError, match=r"no digest is recorded for moves\.csv.*accept_unverified"):
        fetch(entry("http://127.0.0.1:9/moves.csv", None), tmp_path / "none")
    assert not (tmp_path / "none").exists()


def test_an_accepted_file_is_told_with_its_digest(server: str, tmp_path: Path) -> None:
    heard: list[str] = []
    (done,) = fetch(entry(f"{server}/moves.csv", None), tmp_path, accept_unverified=True, say=heard.append)
    assert not done.verified
    assert "not verified" in heard[-1]
    assert DIGEST in heard[-1]


def test_a_file_already_there_is_checked_and_never_replaced(server: str, tmp_path: Path) -> None:
    place = tmp_path / "moves.csv"
    place.write_bytes(b"mine")
    with pytest.raises(SourceError, match="expected sha256"):
        fetch(entry(f"{server}/moves.csv"), tmp_path, say=lambda _: None)
    assert place.read_bytes() == b"mine"
    place.write_bytes(BODY)
    (done,) = fetch(entry("http://127.0.0.1:9/moves.csv"), tmp_path, say=lambda _: None)
    assert done.verified


def test_a_failure_leaves_no_folder_that_it_made(server: str, tmp_path: Path) -> None:
    (tmp_path / "kept").mkdir()
    for folder in (tmp_path / "kept", tmp_path / "kept" / "deep" / "er"):
        with pytest.raises(SourceError):
            fetch(entry(f"{server}/missing.csv"), folder, say=lambda _: None)
    assert (tmp_path / "kept").is_dir()
    assert not list((tmp_path / "kept").iterdir())
    (tmp_path / "kept" / "mine.txt").write_text("mine")
    with pytest.raises(SourceError):
        fetch(entry(f"{server}/missing.csv"), tmp_path / "kept", say=lambda _: None)
    assert (tmp_path / "kept" / "mine.txt").exists()


def test_the_list_cuts_no_address_where_it_is_piped(command) -> None:
    said = command("datasets", "list").out
    pages = [known.page for known in listing() if not known.fetchable]
    assert pages
    assert all(page in said for page in pages)
    assert len(said.splitlines()) == len(listing()) + 1


@pytest.mark.parametrize(
    "url", ["http://example.org/a", "ftp://example.org/a", "file:///etc/passwd", "https:///a", "moves.csv"]
)
def test_other_addresses_are_refused(url: str) -> None:
    with pytest.raises(ParameterError, match="only https is fetched"):
        check_url(url)


def test_a_name_from_the_catalogue_never_leaves_the_folder(server: str, tmp_path: Path) -> None:
    file = RemoteFile("../moves.csv", f"{server}/moves.csv", DIGEST)
    bad = DataSet("test", "Test", "", "MIT", "Someone", 1, 1, "", "", files=(file,))
    (done,) = fetch(bad, tmp_path / "inner", say=lambda _: None)
    assert done.path == tmp_path / "inner" / "moves.csv"


def test_the_catalogue_is_consistent() -> None:
    names = [known.name for known in listing()]
    assert len(names) == len(set(names)) == 12
    formats = {known.key for known in FORMATS}
    for known in listing():
        assert known.licence
        assert known.citation
        assert known.page.startswith("https://")
        assert known.importer is None or known.importer in formats
        for file in known.files:
            check_url(file.url)
            assert re.fullmatch("[0-9a-f]{64}", file.sha256 or "")
            assert re.search("/[0-9a-f]{40}/", file.url), "a commit is pinned"
            assert " " not in file.url


def test_pickles_are_fetched_and_never_opened() -> None:
    assert (find("freihaut2021").importer, find("freihaut2021").reading) == (None, None)
    assert "never opens it" in find("freihaut2021").note


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("balabitt", "did you mean 'balabit'"),
        ("sapimouse", r"sapimouse cannot be fetched.*https://ms\.sapientia\.ro"),
    ],
)
def test_unknown_and_unfetchable_sets_are_told(name: str, words: str, tmp_path: Path) -> None:
    with pytest.raises(ParameterError, match=words):
        fetch(name, tmp_path)
