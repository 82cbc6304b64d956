"""One simulated person at work: which control of which window each movement is for."""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt

import msgspec
import numpy as np

from pointpred.simulation.desktop import windows
from pointpred.simulation.desktop.habits import Habit, draw_habits
from pointpred.simulation.desktop.scenario import Scenario
from pointpred.simulation.desktop.windows import ANYWHERE, Control, Window

LEAST_FREE, MOST_FREE = 0.2, 0.4
FREE_IN_TEXT = 0.7
"""Share of the free clicks that go into the text; the others go anywhere on the screen."""
SWITCH = 0.08
"""How probable a switch of the window is wherever a sequence may begin, with several windows."""
SCATTER = 1.0 / 4.133
"""Standard deviation of the ends along each side of a control, as a share of the side (ISO 9241-411)."""
OWN_SCATTER = 0.19
"""What the simulated hand scatters by itself: its standard deviation as a share of the target's width."""
MOST_SCATTER = 2.5
"""Standard deviations; nobody clicks farther from where they meant to."""


class Step(msgspec.Struct, frozen=True):
    """What a movement is for: the window in front when it begins, and a control."""

    window: Window
    control: Control


class Worker:
    """The windows and habits of a person, and what they were about to do.

    Everything is drawn from the generator given first; what each movement is for from the one given then.
    """

    def __init__(self, scenario: Scenario, generator: np.random.Generator) -> None:
        free = float(generator.uniform(LEAST_FREE, MOST_FREE))
        count = scenario.windows
        self._scenario = scenario
        self._windows = [windows.draw_window(f"window {k}", generator) for k in range(count)]
        self._habits = [
            draw_habits(free, generator, context_menus=scenario.context_menus) for _ in range(count)
        ]
        self._later = [windows.moved(one, generator) for one in self._windows]
        self._changed = False
        self._front = 0
        self._next_front = 0
        self._coming: list[Control] = []
        self._last = ""

    @property
    def habits(self) -> Sequence[Habit]:
        """The habit in each window."""
        return [pair[self._changed and self._scenario.new_habits] for pair in self._habits]

    def change(self) -> None:
        """From now on windows stand elsewhere, or habits are others, as the scenario says."""
        self._changed = True
        if self._scenario.moves:
            self._windows = self._later
        if self._scenario.new_habits:
            self._coming = []

    def step(self, generator: np.random.Generator) -> Step:
        """What the next movement is for."""
        self._front = self._next_front
        if not self._coming:
            self._coming = self._plan(generator)
        control = self._coming.pop(0)
        self._last = control.name
        return Step(self._windows[self._front], control)

    def _plan(self, generator: np.random.Generator) -> list[Control]:
        """A switch to another window, a free click, or a sequence of the habit."""
        switch, free, where = generator.uniform(size=3)
        window, habit = self._windows[self._front], self.habits[self._front]
        if len(self._windows) > 1 and switch < SWITCH:
            others = [k for k in range(len(self._windows)) if k != self._front]
            self._next_front = int(generator.choice(others))
            return [windows.task_button(self._next_front)]
        if free < habit.free_choice:
            return [window.controls["text"] if where < FREE_IN_TEXT else ANYWHERE]
        return [window.controls[name] for name in habit.choose(self._last, generator)]


def place_of(step: Step, cursor: tuple[float, float]) -> tuple[float, float]:
    """The centre of a step's control on the screen, px, with the cursor where it is."""
    origins = {"window": (step.window.x, step.window.y), "screen": (0.0, 0.0), "cursor": cursor}
    x, y = origins[step.control.of]
    return x + step.control.x, y + step.control.y


def aim_at(control: Control, generator: np.random.Generator) -> tuple[float, float, float]:
    """The point a person means to reach, from the control's centre, and the precision in its place, px.

    With the hand's own scatter, ends scatter normally with ``SCATTER`` times the side along each side; in an
    area they scatter evenly.
    """
    sides = control.width, control.height
    if control.area:
        x, y = (float(generator.uniform(-0.5, 0.5)) * (side - control.precision_px) for side in sides)
        return x, y, control.precision_px
    precision = min(sides)
    own = OWN_SCATTER * precision
    x, y = (
        float(np.clip(generator.standard_normal(), -MOST_SCATTER, MOST_SCATTER))
        * sqrt(max((SCATTER * side) ** 2 - own**2, 0.0))
        for side in sides
    )
    return x, y, precision
