"""What a simulated person does in a window: sequences of controls, each as often as its rank says."""

from __future__ import annotations

import msgspec
import numpy as np

from pointpred.records import FloatArray
from pointpred.simulation.desktop.windows import ENTRIES, ICONS, ITEMS, MENUS, TOOLS

SINGLE_BUTTONS, MENU_SEQUENCES = 5, 3
"""Sequences of a habit with one button or entry, and those that begin by opening a menu."""


class Habit(msgspec.Struct, frozen=True):
    """Sequences of controls, by name, the most frequent first: the k-th is chosen with weight 1/k (Zipf).

    ``free``: share of the movements that go to no control: into the text, or anywhere on the screen.
    """

    sequences: tuple[tuple[str, ...], ...]
    free: float

    @property
    def weights(self) -> FloatArray:
        """The probability of each sequence."""
        ranks = 1.0 / np.arange(1.0, len(self.sequences) + 1.0)
        return np.asarray(ranks / ranks.sum())

    @property
    def free_choice(self) -> float:
        """How probable a free click is wherever a sequence may begin, so that ``free`` of the movements are.

        With sequences of L movements on average, p / (p + (1 - p) L) = free.
        """
        mean = float(self.weights @ [len(one) for one in self.sequences])
        return self.free * mean / (1.0 - self.free + self.free * mean)

    def choose(self, last: str, generator: np.random.Generator) -> tuple[str, ...]:
        """A sequence; none that begins with the control that was clicked last."""
        weights = self.weights * [one[0] != last for one in self.sequences]
        return self.sequences[int(generator.choice(len(weights), p=weights / weights.sum()))]


def draw_habits(free: float, generator: np.random.Generator, *, context_menus: bool) -> tuple[Habit, Habit]:
    """Two habits of one person in one window, which share no button, menu item or icon.

    Each has five buttons or entries and an icon of the task bar alone, two buttons one after the other, and
    three menus with an item, two of which open a dialog that has to be confirmed. With ``context_menus`` a
    menu opens at a click into the text.
    """
    buttons = [f"tool {k}" for k in range(TOOLS)] + [f"entry {k}" for k in range(ENTRIES)]
    items = [(menu, item) for menu in range(MENUS) for item in range(ITEMS)]
    if context_menus:
        items = [(-1, item) for item in range(ITEMS)]
    order = generator.permutation(len(buttons)), generator.permutation(len(items))
    icons = generator.permutation(ICONS)
    drawn = []
    for half in range(2):
        mine = [buttons[k] for k in order[0][half::2]]
        opened = [items[k] for k in order[1][half::2]][:MENU_SEQUENCES]
        sequences: list[tuple[str, ...]] = [
            (name,) for name in (*mine[:SINGLE_BUTTONS], f"icon {icons[half]}")
        ]
        sequences += [(mine[SINGLE_BUTTONS], mine[SINGLE_BUTTONS + 1])]
        sequences += [_menu(*one, confirmed=k > 0) for k, one in enumerate(opened)]
        ranked = generator.permutation(len(sequences))
        drawn.append(Habit(tuple(sequences[k] for k in ranked), free))
    return drawn[0], drawn[1]


def _menu(menu: int, item: int, *, confirmed: bool) -> tuple[str, ...]:
    """A menu, its item, and the dialog's button; menu -1 opens at a click into the text."""
    opened = (f"menu {menu}", f"menu {menu} item {item}") if menu >= 0 else ("text", f"context item {item}")
    return (*opened, "dialog ok") if confirmed else opened
