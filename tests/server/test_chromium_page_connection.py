"""The browser client without a service: the same calls and answers, from a session in the page."""

from __future__ import annotations

import json
from typing import Any

import pytest

from tests.page.movements import movements
from tests.page.test_page_places import rounds
from tests.server import browser
from tests.server.listener import soon
from tests.server.page_browser import Visitor

pytestmark = browser.needed

OPEN = """import("/web/lib/pointpred.js").then(({ connect }) => {
  window.talks = [{}, { page: true }].map((more) => {
    const connection = connect(undefined, { pointer: false, encoding: "json", ...OPTIONS, ...more });
    const heard = [];
    for (const name of ["prediction", "choice", "score", "error", "person", "cursor"])
      connection.on(name, (message) => heard.push(message));
    return { connection, heard };
  });
})"""
TARGETS = [
    {"id": f"{i},{j}", "x": 240.0 * i, "y": 240.0 * j, "width": 60.0, "height": 60.0}
    for i in range(-2, 7)
    for j in range(-2, 7)
]


def open_both(one: Visitor, url: str, **options: Any) -> None:
    """Two connections with the same options: to the service, and in the page."""
    one.open(f"{url}/web/page/example.html")
    one.value(OPEN.replace("OPTIONS", json.dumps(options)))
    soon(lambda: states(one) == ["open", "open"], "both connections are open")


def states(one: Visitor) -> list[str]:
    return one.value("talks.map(({ connection }) => connection.state)")


def both(one: Visitor, call: str) -> None:
    one.value(f"talks.forEach(({{ connection }}) => {call}) ?? null")


def heard(one: Visitor, kind: str, fields: str) -> list[list[Any]]:
    """What both connections heard of a kind, some fields of each message."""
    pick = f"heard.filter(({{ type }}) => type === '{kind}').map(({{ {fields} }}) => [{fields}])"
    return one.value(f"talks.map(({{ heard }}) => {pick})")


def send(one: Visitor, rows: list[list[float]], size: int) -> None:
    """Send rows in messages of a size, and wait until both have answered the last one."""
    plain = [[*row[:3], None, None, int(row[5])] for row in rows]
    for at in range(0, len(plain), size):
        both(one, f"connection.send({json.dumps(plain[at : at + size])})")
        wait_for(one, plain[min(at + size, len(plain)) - 1][0])


def wait_for(one: Visitor, t: float) -> None:
    """Wait until both have answered the event of a time."""
    newest = "talks.map(({ heard }) => heard.findLast(({ type }) => type === 'prediction')?.t)"
    soon(lambda: one.value(newest) == [t, t], "both answered")


def test_a_connection_in_the_page_gives_what_the_service_gives(one: Visitor, url: str) -> None:
    open_both(one, url, targets=TARGETS, predictor="kinematic-adaptive")
    both(one, "connection.configure({ precision: 0.2 })")
    soon(
        lambda: len(one.value("talks.map(({connection}) => connection.welcome?.predictor)")) == 2,
        "configured",
    )
    both(one, "connection.trial('start')")
    rows = movements(21, count=2).tolist()
    send(one, rows, 12)
    goal = {"x": rows[-1][1], "y": rows[-1][2], "width": 40}
    both(one, f"connection.trial('end', {json.dumps(goal)})")
    soon(lambda: [len(a) for a in heard(one, "score", "skill")] == [1, 1], "both trials are scored")
    service, page = heard(one, "prediction", "t, x, y")
    assert [row for row in page if row[1] is not None]
    assert service == [pytest.approx(row, abs=1e-6) for row in page]
    service, page = heard(one, "choice", "id, action, t, reason")
    assert page
    assert service == page
    (service,), (page,) = heard(one, "score", "events, skill, fired, wasted")
    assert service == pytest.approx(page, abs=1e-6)
    assert heard(one, "error", "code, message") == [[], []]
    best = "connection.probability(heard.findLast(({ targets }) => targets).targets[0].id)"
    probable = one.value(f"talks.map(({{ heard, connection }}) => {best})")
    assert probable[0] == pytest.approx(probable[1], abs=1e-6)
    assert probable[0] > 0.0
    assert 0.0 < one.value("talks[1].connection.delayMs") < 1000.0


def test_a_person_and_another_predictor_in_the_page(one: Visitor, url: str) -> None:
    open_both(one, url)
    send(one, movements(22, count=3).tolist(), 20)
    both(one, "connection.reset()")
    known = one.value("Promise.all(talks.map(({ connection }) => connection.person()))")
    assert [len(person) > 1000 for person in known] == [True, True]
    both(one, "connection.configure({ predictor: 'switched' })")
    soon(
        lambda: one.value("talks.map(({ connection }) => connection.welcome.predictor)") == ["switched"] * 2,
        "switched",
    )
    both(one, "connection.configure({ predictor: 'swiched' })")
    soon(lambda: [len(a) for a in heard(one, "error", "code")] == [1, 1], "both refuse")
    assert heard(one, "error", "code, path") == [[["unknown_predictor", "$.predictor"]]] * 2
    refused = "talks[1].connection.person('1.AAAA').catch((error) => error.name)"
    assert one.value(refused) == "RangeError"
    assert states(one) == ["open", "open"]
    both(one, "connection.close()")
    assert states(one) == ["closed", "closed"]


def test_a_predictor_that_nobody_knows_leaves_the_connection_refused(one: Visitor, url: str) -> None:
    one.open(f"{url}/web/page/example.html")
    one.value(OPEN.replace("OPTIONS", '{ predictor: "nobody" }'))
    soon(lambda: states(one) == ["refused", "refused"], "both are refused")
    both(one, "connection.configure({ predictor: 'hold' })")
    soon(lambda: states(one) == ["open", "open"], "both are open")


def test_modules_that_cannot_be_loaded_are_tried_again(one: Visitor, url: str) -> None:
    one.open(f"{url}/web/page/example.html")
    one.hand.call("Network.enable")
    one.hand.call("Network.setBlockedURLs", urls=["*kinematic.js"])
    one.value(OPEN.replace("OPTIONS", "{}"))
    soon(lambda: states(one) == ["open", "waiting"], "the page cannot fetch its coefficients")
    one.hand.call("Network.setBlockedURLs", urls=[])
    soon(lambda: states(one) == ["open", "open"], "the page has tried again")


def test_places_windows_and_forgetting_in_the_page(one: Visitor, url: str) -> None:
    open_both(one, url, places=True, predictor="kinematic-adaptive")
    for rows in rounds(9, 9):
        send(one, [[*row[:3], 0.0, 0.0, 0.0] for row in rows], 11)
        both(one, "connection.reset()")
    # The service answers the last reset a little later than the page.
    soon(lambda: len({len(choices) for choices in heard(one, "choice", "id")}) == 1, "both heard all choices")
    service, page = heard(one, "choice", "id, action, reason, p, t, place")
    assert page
    assert {one[2] for one in page} == {"predicted", "entered", None}
    for here, there in zip(page, service, strict=True):
        assert here[:3] == there[:3]
        assert here[3:5] == pytest.approx(there[3:5], abs=1e-6)
        assert here[5] == pytest.approx(there[5], abs=1e-5)
    both(one, "connection.enter('editor', 10)")
    one.value("talks.forEach(({ heard }) => heard.splice(0)) ?? null")
    send(one, [[*row[:3], 0.0, 0.0, 0.0] for row in rounds(10, 1, start_s=100.0)[0]], 11)
    assert heard(one, "choice", "id") == [[], []]
    both(one, "connection.enter('')")
    send(one, [[*row[:3], 0.0, 0.0, 0.0] for row in rounds(11, 1, start_s=200.0)[0]], 11)
    service, page = heard(one, "choice", "id, action, reason")
    assert page == service != []
    assert one.value("Promise.all(talks.map(({ connection }) => connection.forget()))") == ["", ""]
    assert one.value("Promise.all(talks.map(({ connection }) => connection.person()))") == ["", ""]
    both(one, "connection.configure({ places: 'yes' })")
    soon(lambda: [len(a) for a in heard(one, "error", "code")] == [1, 1], "both refuse")
    assert heard(one, "error", "code, path") == [[["bad_field", "$.places"]]] * 2


def test_events_that_wait_are_forgotten_with_the_person(one: Visitor, url: str) -> None:
    one.open(f"{url}/web/page/example.html")
    one.value("""import("/web/lib/pointpred.js").then(async ({ connect }) => {
      const connection = window.late = connect(undefined, { page: true, pointer: false });
      connection.send([[0, 1, 1, null, null, 0], [0.01, 2, 2, null, null, 0]]);
      await connection.forget();
    })""")
    soon(lambda: one.value("late.state") == "open", "the connection is open")
    assert one.value("[late.sent, late.dropped]") == [0, 2]


@pytest.mark.parametrize(("places", "most"), [("false", 60), ("true", 7)])
def test_no_more_waiting_events_are_sent_than_the_service_takes(
    one: Visitor, url: str, places: str, most: int
) -> None:
    """Three quarters of 80 a second; with places each counts 8 times."""
    one.open(f"{url}/web/page/example.html")
    sent = one.value(f"""import("/web/lib/client/event-queue.js").then(({{ EventQueue }}) => {{
      const queue = new EventQueue(100);
      queue.add(Array.from({{ length: 90 }}, (_, i) => [i, 1, 1, null, null, 0]));
      return queue.drain({{ max_events_per_s: 80 }}, 0, {places}).flatMap(({{ rows }}) => rows).length;
    }})""")
    assert sent == most
