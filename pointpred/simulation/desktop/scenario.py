"""What a simulated desktop has, and what happens on it after half of the movements."""

from __future__ import annotations

import msgspec

from pointpred.errors import ParameterError


class Scenario(msgspec.Struct, frozen=True):
    """How many windows a person works in, whether menus open at the cursor, and what changes.

    ``moves``: every window stands elsewhere from the change on, 200 to 500 px away; ``new_habits``: from the
    change on the person uses other buttons, other menu items and other sequences of them.
    """

    windows: int = 1
    context_menus: bool = False
    moves: bool = False
    new_habits: bool = False

    @property
    def changes(self) -> bool:
        """Whether anything changes."""
        return self.moves or self.new_habits


SCENARIOS: dict[str, Scenario] = {
    "steady": Scenario(),
    "moved": Scenario(moves=True),
    "habits": Scenario(new_habits=True),
    "menus": Scenario(context_menus=True),
    "windows": Scenario(windows=3),
}
"""By name; a person's first movements are the same in ``steady``, ``moved`` and ``habits``."""


def named(name: str) -> Scenario:
    """A scenario by its name; raises ParameterError."""
    if name not in SCENARIOS:
        message = f"scenario must be one of {', '.join(SCENARIOS)}, received {name!r}"
        raise ParameterError(message, field="scenario", value=name)
    return SCENARIOS[name]
