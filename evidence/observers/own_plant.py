"""Draw the figure of the guide to an own plant, from the examples of that page."""

from __future__ import annotations

import doctest
from typing import Any

from evidence import ROOT
from evidence.arguments import parse

PAGE = ROOT / "observers" / "docs" / "own-plant.md"
FIGURE = PAGE.parent / "figures" / "own-plant.svg"


def names() -> dict[str, Any]:
    """The names that the page's examples define; raises where an example does not hold."""
    test = doctest.DocTestParser().get_doctest(PAGE.read_text(encoding="utf-8"), {}, PAGE.name, str(PAGE), 0)
    doctest.DebugRunner().run(test, clear_globs=False)
    return test.globs


if __name__ == "__main__":
    parse(__doc__)
    names()["result"].plot(FIGURE)
