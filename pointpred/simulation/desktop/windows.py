"""Windows of a simulated desktop and their controls: where each one stands and how large it is."""

from __future__ import annotations

from typing import Literal

import msgspec
import numpy as np

SCREEN_PX = (1920.0, 1080.0)
ROOM_PX = (1800.0, 980.0)
"""Windows lie within this part of the screen, so that a menu that opens at the cursor fits on it."""
MENUS, ITEMS, TOOLS, ENTRIES, ICONS = 4, 6, 8, 8, 4
"""Menus, items in each menu, buttons of the toolbar, entries of the side bar, icons on the task bar."""
ITEM_PX = 26.0
"""Height of a menu's item; the first one begins at the lower edge of what opens the menu."""
NEAREST_MOVE_PX, FARTHEST_MOVE_PX = 200.0, 500.0


class Control(msgspec.Struct, frozen=True):
    """Something to click: centre and sides in px, relative to its window, the screen, or the cursor.

    ``of`` is ``"cursor"`` for the items of a menu that opens where the last movement ended. In an ``area``
    people click anywhere, at things of ``precision_px``; elsewhere at the control itself.
    """

    name: str
    x: float
    y: float
    width: float
    height: float
    of: Literal["window", "screen", "cursor"] = "window"
    area: bool = False
    precision_px: float = 20.0


ANYWHERE = Control("anywhere", SCREEN_PX[0] / 2, SCREEN_PX[1] / 2, 1840.0, 960.0, "screen", True, 40.0)
"""The whole screen."""


class Window(msgspec.Struct, frozen=True):
    """A window: its key, its upper left corner on the screen, its sides (px) and its controls by name."""

    key: str
    x: float
    y: float
    width: float
    height: float
    controls: dict[str, Control]


def draw_window(key: str, generator: np.random.Generator) -> Window:
    """A window with a menu bar, a toolbar, a side bar, a text area and a dialog, drawn from the generator."""
    width, height = generator.uniform(880.0, 1120.0), generator.uniform(620.0, 740.0)
    controls = [
        *_menu_bar(generator),
        *_toolbar(generator),
        *(Control(f"entry {k}", 105.0, 140.0 + 40.0 * k, 180.0, 28.0) for k in range(ENTRIES)),
        Control("text", 0.5 * (width + 200.0), 0.5 * height + 30.0, width - 240.0, height - 200.0, area=True),
        Control("dialog ok", 0.5 * width + 40.0, 0.5 * height + 90.0, 88.0, 28.0),
        *(_item(f"context item {k}", 70.0, 0.0, k, "cursor") for k in range(ITEMS)),
        *(Control(f"icon {k}", 600.0 + 64.0 * k, 1056.0, 48.0, 40.0, "screen") for k in range(ICONS)),
    ]
    x, y = generator.uniform(0.0, ROOM_PX[0] - width), generator.uniform(0.0, ROOM_PX[1] - height)
    return Window(key, float(round(x)), float(round(y)), width, height, {one.name: one for one in controls})


def moved(window: Window, generator: np.random.Generator) -> Window:
    """The same window at another place of the screen, 200 to 500 px away."""
    while True:
        x = float(round(generator.uniform(0.0, ROOM_PX[0] - window.width)))
        y = float(round(generator.uniform(0.0, ROOM_PX[1] - window.height)))
        if NEAREST_MOVE_PX <= np.hypot(x - window.x, y - window.y) <= FARTHEST_MOVE_PX:
            return msgspec.structs.replace(window, x=x, y=y)


def task_button(number: int) -> Control:
    """The button on the task bar that brings a window to the front."""
    return Control(f"task {number}", 160.0 + 150.0 * number, 1056.0, 140.0, 40.0, "screen")


def _menu_bar(generator: np.random.Generator) -> list[Control]:
    """The menus' heads in a row, and the items below each."""
    controls, left = [], 8.0
    for menu in range(MENUS):
        width = float(generator.uniform(44.0, 76.0))
        controls.append(Control(f"menu {menu}", left + 0.5 * width, 42.0, width, 24.0))
        controls += [_item(f"menu {menu} item {k}", left + 90.0, 54.0, k) for k in range(ITEMS)]
        left += width
    return controls


def _item(
    name: str, x: float, top: float, number: int, of: Literal["window", "cursor"] = "window"
) -> Control:
    """An item of a menu whose first item begins at ``top``."""
    return Control(name, x, top + ITEM_PX * (number + 0.5), 180.0 if of == "window" else 140.0, ITEM_PX, of)


def _toolbar(generator: np.random.Generator) -> list[Control]:
    """Buttons in a row, with gaps between groups."""
    side = float(generator.uniform(28.0, 36.0))
    centres = 30.0 + np.cumsum(side + generator.choice([4.0, 8.0, 60.0], TOOLS))
    return [Control(f"tool {k}", float(x), 86.0, side, side) for k, x in enumerate(centres)]
