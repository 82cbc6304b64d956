"""A real service shows the metrics and log entries that the page lists; alerts and dashboard use no other."""

from __future__ import annotations

import json
import re
import shutil
import socket
import subprocess
from pathlib import Path
from typing import Any
from urllib.error import HTTPError
from urllib.request import Request, urlopen

import pytest
import yaml
from prometheus_client.metrics_core import Metric
from prometheus_client.parser import text_string_to_metric_families
from websockets.sync.client import connect
from websockets.typing import Subprotocol

from tests.operations.monitoring import (
    DEPLOY,
    listed_fields,
    listed_metrics,
    listed_samples,
    names_in,
)
from tests.server.listener import soon
from tests.server.process import Served, served
from tests.server.running import HELLO, PATIENCE_S

TOKEN = "sesame-open-12345"
POSITION = "731.52"
RULES = DEPLOY / "alerts.yaml"
ALERTS = [rule for group in yaml.safe_load(RULES.read_text())["groups"] for rule in group["rules"]]
DASHBOARD: dict[str, Any] = json.loads((DEPLOY / "dashboard.json").read_text())
EXPRESSIONS = [target["expr"] for panel in DASHBOARD["panels"] for target in panel["targets"]]


def use(service: Served) -> None:
    """A session that moves and errs, a client that goes away, a request without the token."""
    url = f"ws://127.0.0.1:{service.port}/v1/stream?token={TOKEN}"
    for leave in (True, False):
        with connect(
            url, subprotocols=[Subprotocol("pointpred.v1")], proxy=None, ping_interval=None
        ) as socket:
            socket.send(HELLO)
            assert '"welcome"' in socket.recv(PATIENCE_S)  # type: ignore[operator]
            socket.send(f'{{"type":"events","events":[[1.25,{POSITION},6,null,null,0]]}}')
            assert '"prediction"' in socket.recv(PATIENCE_S)  # type: ignore[operator]
            socket.send('{"type":"events","events":[[1.25,"here",6,null,null,0]]}')
            assert '"bad_field"' in socket.recv(PATIENCE_S)  # type: ignore[operator]
            if leave:
                socket.send('{"type":"bye"}')
                with pytest.raises(Exception, match="bye"):
                    socket.recv(PATIENCE_S)
            else:
                socket.socket.close()
    with pytest.raises(HTTPError):
        urlopen(Request(f"{service.url}/v1/predictors", headers={"Origin": "http://elsewhere.example"}))


def test_a_service_shows_the_listed_metrics_and_log_fields(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("POINTPRED_TOKEN", TOKEN)
    monkeypatch.setenv("POINTPRED_MAX_SESSIONS", "7")
    with served("--metrics-port", str(port := free_port())) as service:
        use(service)

        def shown() -> list[Metric]:
            with urlopen(f"http://127.0.0.1:{port}/metrics", timeout=PATIENCE_S) as answer:
                return list(text_string_to_metric_families(answer.read().decode()))

        def names() -> set[str]:
            named = {family.name + ("_total" if family.type == "counter" else "") for family in shown()}
            return {name for name in named if not name.endswith("_created")}

        soon(lambda: names() == set(listed_metrics()), "every metric is shown")
        (limit,) = [family for family in shown() if family.name == "pointpred_sessions_limit"]
        assert limit.samples[0].value == 7
    entries = [json.loads(line) for line in service.log if line.startswith("{")]
    assert entries
    seen = {field for entry in entries for field in entry}
    assert seen <= listed_fields()
    assert seen >= {"time", "level", "logger", "message", "session", "code", "events"}
    for entry in entries:
        text = json.dumps(entry)
        assert TOKEN not in text
        assert POSITION not in text
        assert "127.0.0.1" not in text or entry["message"].startswith(("Ready", "Metrics", "Settings"))


def free_port() -> int:
    """A port that nobody has just now."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port: int = free.getsockname()[1]
    return port


@pytest.mark.parametrize("rule", ALERTS, ids=[rule["alert"] for rule in ALERTS])
def test_an_alert_names_metrics_that_exist_and_says_what_to_do(rule: dict[str, Any]) -> None:
    assert names_in(rule["expr"]) <= listed_samples()
    assert names_in(rule["expr"]) or rule["expr"].startswith("up{")
    assert 'job="pointpred"' in rule["expr"]
    assert rule["annotations"].keys() == {"summary", "action"}
    assert re.fullmatch(r"[A-Z].+\.", rule["annotations"]["action"])


@pytest.mark.parametrize("expression", EXPRESSIONS)
def test_an_expression_of_the_dashboard_names_metrics_that_exist(expression: str) -> None:
    assert names_in(expression)
    assert names_in(expression) <= listed_samples()


def test_the_dashboard_has_what_the_schema_of_grafana_asks_for() -> None:
    """Of grafana/grafana, kinds/dashboard/dashboard_kind.cue."""
    assert DASHBOARD["schemaVersion"] == 39
    variables = {one["name"]: one["type"] for one in DASHBOARD["templating"]["list"]}
    assert variables == {"source": "datasource", "instance": "query"}
    for panel in DASHBOARD["panels"]:
        assert panel["type"] == "timeseries"
        assert panel["title"]
        place = panel["gridPos"]
        assert min(place["x"], place["y"]) >= 0
        assert min(place["w"], place["h"]) > 0
        assert place["x"] + place["w"] <= 24
        assert panel["datasource"] == {"type": "prometheus", "uid": "${source}"}
        assert panel["fieldConfig"].keys() == {"defaults", "overrides"}
        names = [target["refId"] for target in panel["targets"]]
        assert names
        assert len(set(names)) == len(names)


def test_the_panels_of_the_dashboard_do_not_overlap() -> None:
    cells: set[tuple[int, int]] = set()
    for panel in DASHBOARD["panels"]:
        place = panel["gridPos"]
        own = {(place["x"] + x, place["y"] + y) for x in range(place["w"]) for y in range(place["h"])}
        assert not cells & own
        cells |= own
    assert len({panel["id"] for panel in DASHBOARD["panels"]}) == len(DASHBOARD["panels"])


needs_promtool = pytest.mark.skipif(
    shutil.which("promtool") is None, reason="promtool (Debian package prometheus) is not installed"
)


@needs_promtool
def test_alerts_fire_for_series_that_are_wrong_and_for_no_other() -> None:
    done = promtool("test", "rules", str(Path(__file__).parent / "alerts_test.yaml"))
    assert done.returncode == 0, done.stdout + done.stderr


@needs_promtool
def test_every_alert_is_tested_with_a_series_that_fires_and_one_that_does_not() -> None:
    tests = yaml.safe_load((Path(__file__).parent / "alerts_test.yaml").read_text())["tests"]
    cases = [case for test in tests for case in test["alert_rule_test"]]
    for rule in ALERTS:
        fires = {bool(case["exp_alerts"]) for case in cases if case["alertname"] == rule["alert"]}
        assert fires == {True, False}, rule["alert"]


@needs_promtool
def test_prometheus_parses_the_expressions_of_the_dashboard(tmp_path: Path) -> None:
    """As recording rules: promtool checks no query alone. Grafana fills in its variables before."""
    filled = [re.sub(r"\$__\w+", "5m", expression).replace("$instance", ".+") for expression in EXPRESSIONS]
    rules = [
        {"record": f"dashboard:{number}", "expr": expression} for number, expression in enumerate(filled)
    ]
    path = tmp_path / "rules.yaml"
    path.write_text(yaml.safe_dump({"groups": [{"name": "dashboard", "rules": rules}]}))
    done = promtool("check", "rules", str(path))
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"{len(rules)} rules found" in done.stdout


def promtool(*arguments: str) -> subprocess.CompletedProcess[str]:
    """Run it."""
    return subprocess.run(["promtool", *arguments], capture_output=True, text=True, check=False)
