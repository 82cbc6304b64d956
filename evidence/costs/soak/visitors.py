"""People with a browser, and what collects metrics: ``python -m evidence.costs.soak.visitors PLAN``."""

from __future__ import annotations

import http.client
import random
import threading
import time

import msgspec

from evidence.arguments import parse
from evidence.costs.soak.client import events
from evidence.costs.soak.reports import Plan, Reporter

PATHS = ("/", "/metrics", "/metrics", "/pointpred.js", "/v1/predictors", "/healthz", "/readyz", "/v1/samples")
VISITORS = 2
TIMEOUT_S = 60.0
REST_S = 0.5


def recording() -> bytes:
    """A small recording as CSV, for /v1/score."""
    rows = events(3, 500.0, 0, 400)
    lines = [f"{row[0]},{row[1]},{row[2]},{row[3]},{row[4]},{int(row[5])}" for row in rows.tolist()]
    return "\n".join(["t_s,x_px,y_px,dx_counts,dy_counts,buttons", *lines, ""]).encode()


def visit(plan: Plan, reporter: Reporter, number: int) -> None:
    """One visitor: a request after another, some on a connection of its own."""
    chance, body = random.Random(plan.seed * 1000 + 900 + number), recording()
    connection = http.client.HTTPConnection("127.0.0.1", plan.port, timeout=TIMEOUT_S)
    while not reporter.stopping.is_set():
        try:
            if chance.random() < 0.15:
                connection.request("POST", "/v1/score?predictors=hold,linear", body)
            else:
                connection.request("GET", chance.choice(PATHS))
            answer = connection.getresponse()
            answer.read()
            reporter.counts["requests"] += 1
            if answer.status not in {200, 503}:  # uploads of attackers may take all places
                reporter.wrong.append(f"a visitor was answered with {answer.status}")
        except (OSError, http.client.HTTPException) as error:
            reporter.wrong.append(f"a visitor was cut: {type(error).__name__}: {error}")
            connection.close()
        if chance.random() < 0.3:
            connection.close()
        reporter.stopping.wait(REST_S)
    connection.close()


def main(words: str) -> None:
    """Visit until stdin is closed."""
    plan = msgspec.json.decode(words, type=Plan)
    reporter = Reporter(plan)
    threads = [threading.Thread(target=visit, args=(plan, reporter, n)) for n in range(VISITORS)]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        time.sleep(1.0)
        reporter.write()
    reporter.write()


if __name__ == "__main__":
    main(parse(__doc__, metavar="PLAN", most=1)[0])
