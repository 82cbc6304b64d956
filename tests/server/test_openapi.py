"""The OpenAPI document says what the HTTP part answers, and the answers are as it says."""

from __future__ import annotations

import inspect
import json
from pathlib import Path
from typing import Any

import pytest
from fastapi.testclient import TestClient

from pointpred_server.app import create_app
from pointpred_server.service import Service
from pointpred_server.settings import Settings

HERE = "http://127.0.0.1:8765"
COMMITTED = Path(__file__).parents[2] / "docs" / "reference" / "openapi.json"
ERROR = {"$ref": "#/components/schemas/Error"}
SHAPE = {"type", "code", "message", "path", "recoverable"}
OPEN = ("/healthz", "/readyz", "/pointpred.js", "/v1/origin")
"""What needs no token."""


@pytest.fixture(scope="module")
def client() -> TestClient:
    return TestClient(create_app(), base_url=HERE)


@pytest.fixture(scope="module")
def document(client: TestClient) -> dict[str, Any]:
    answer = client.get("/openapi.json")  # a warning would be an error here
    assert answer.status_code == 200
    told: dict[str, Any] = answer.json()
    return told


def operations(document: dict[str, Any]) -> dict[tuple[str, str], dict[str, Any]]:
    return {(path, way): each for path, ways in document["paths"].items() for way, each in ways.items()}


def test_what_is_served_is_what_is_written_in_the_pages(document: dict[str, Any]) -> None:
    assert document == json.loads(COMMITTED.read_text(encoding="utf-8"))


def test_every_operation_has_a_name_of_its_own_and_a_sentence(document: dict[str, Any]) -> None:
    each = operations(document)
    assert len({one["operationId"] for one in each.values()}) == len(each) >= 9
    for one in each.values():
        assert one["summary"] == inspect.cleandoc(one["summary"])
        assert one["summary"].endswith(".")


def test_every_refusal_is_described_in_the_one_shape(document: dict[str, Any]) -> None:
    shape = document["components"]["schemas"]["Error"]
    assert set(shape["required"]) == SHAPE
    assert shape["properties"].keys() == SHAPE | {"field", "value"}
    assert "HTTPValidationError" not in document["components"]["schemas"]
    for (path, way), one in operations(document).items():
        refused = {status: said for status, said in one["responses"].items() if status != "200"}
        assert {"403", "500"} <= refused.keys(), path
        assert ("401" in refused) == (path not in OPEN), path
        for status, said in refused.items():
            if (path, status) != ("/readyz", "503"):
                assert said["content"]["application/json"]["schema"] == ERROR, (way, path, status)


@pytest.mark.parametrize("path", ["/", *OPEN, "/v1/samples"])
def test_answers_are_of_the_type_that_is_described(
    client: TestClient, document: dict[str, Any], path: str
) -> None:
    for answer in (client.get(path), client.head(path)):
        said = document["paths"][path]["get"]["responses"][str(answer.status_code)]
        (kind,) = said["content"]
        assert answer.headers["content-type"].partition(";")[0] == kind.partition(";")[0]
    assert answer.content == b""


@pytest.mark.parametrize(
    ("way", "path", "status", "code", "words"),
    [
        ("GET", "/nowhere", 404, "bad_field", "/nowhere"),
        ("GET", "/web/nothing.js", 404, "bad_field", "/web/nothing.js"),
        ("POST", "/nowhere", 404, "bad_field", "/nowhere"),
        ("POST", "/healthz", 405, "out_of_place", "/healthz answers GET, HEAD, received POST"),
        ("DELETE", "/web/page/page.js", 405, "out_of_place", "answers GET, HEAD, received DELETE"),
    ],
)
def test_what_is_not_there_is_said_in_the_shape_of_errors(
    client: TestClient, way: str, path: str, status: int, code: str, words: str
) -> None:
    answer = client.request(way, path)
    told = answer.json()
    assert (answer.status_code, told.keys(), told["code"]) == (status, SHAPE, code)
    assert words in told["message"]
    assert answer.headers["x-content-type-options"] == "nosniff"
    assert status != 405 or answer.headers["allow"] in told["message"]


def test_the_document_asks_for_the_token_as_the_page_does() -> None:
    guarded = TestClient(create_app(service=Service(Settings(token="open-sesame-9"))), base_url=HERE)
    assert guarded.get("/openapi.json").status_code == 401
