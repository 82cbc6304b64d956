"""A page with registered elements: what fired in it, and a hand for its mouse."""

from __future__ import annotations

from typing import Any

from tests.server.page_browser import Visitor

START = """Promise.all(["index", "register", "later"]
  .map((name) => import(`/pointpred/intent/${name}.js`))).then(([module, { trackers }]) => {
  Object.assign(window, module, { trackers });
  window.ready = () => Promise.all([...trackers.values()].map(({ ready }) => ready));
  window.measured = (id) => [...trackers.values()].flatMap(({ shares }) => shares.entries)
    .find(({ element }) => element.id === id);
  window.heard = [];
  window.stops = {};
  window.box = (id, left, top, width = 100, height = 60, tag = "button") => {
    const element = document.createElement(tag);
    element.id = id;
    element.textContent = id;
    element.style = `position: absolute; left: ${left}px; top: ${top}px; width: ${width}px;
      height: ${height}px; padding: 0`;
    document.body.append(element);
    return element;
  };
  window.watch = (element, options = {}) => {
    stops[element.id] = onIntent(element, ({ element, reason, p, t, remaining_s, signal }) => {
      heard.push({ id: element.id, reason, p, t, remaining_s, began: true });
      signals[element.id] = signal;
      return () => heard.push({ id: element.id, began: false });
    }, { predictor: "minimum-jerk", ...options });
  };
  window.signals = {};
  window.said = () => heard.map(({ id, reason, began }) => (began ? `${id} ${reason}` : `${id} ended`));
  window.frames = (count) => new Promise((done) => { const next = () => (
    count-- ? requestAnimationFrame(next) : done()); next(); });
})"""


class IntentPage:
    """One document; ``box`` and ``watch`` are functions in it."""

    def __init__(self, visitor: Visitor, host: str, package: str = "/pointpred") -> None:
        self.visitor = visitor
        visitor.open(f"{host}/page.html")
        visitor.value(START.replace("/pointpred/", f"{package}/"))
        self.value, self.wait = visitor.value, visitor.wait

    def make(self, text: str) -> None:
        """Run statements, and wait until the page has seen the new elements."""
        self.value(f"{{ {text} }}")
        self.settle()

    def settle(self) -> None:
        """Wait until predictors are loaded, observers have reported and every element has been measured."""
        self.value("ready().then(() => frames(3))")

    def said(self) -> list[str]:
        """What was called, in order: ``"id reason"`` and ``"id ended"``."""
        answer: list[str] = self.value("said()")
        return answer

    def ledger(self) -> dict[str, Any]:
        """The ledger of the page."""
        answer: dict[str, Any] = self.value("ledger()")
        return answer

    def move(self, start: tuple[float, float], end: tuple[float, float], seconds: float = 0.5) -> None:
        """Move the mouse as a hand does; the page has seen it all afterwards.

        The page draws frames meanwhile, however slow it is: the events have the times that were planned.
        """
        self.visitor.reach(start, end, seconds, paced=True)
        self.settle()

    def away(self) -> None:
        """Rest long enough for the next event to begin a movement."""
        self.value("new Promise((done) => setTimeout(done, 350))")
