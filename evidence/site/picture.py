"""The moving picture of the README: ``python -m evidence site picture``.

Opens the live page as files in Chromium and moves its mouse along movements of the embedded sample, turned
and scaled so that each ends on a tile or above the tiles. What is shown meanwhile is docs/figures/live.webp,
and one frame of it is docs/figures/live.png, for those who want nothing to move. About half a minute.
"""

from __future__ import annotations

import base64
import io
import tempfile
import threading
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image
from playwright.sync_api import CDPSession

from evidence import FIGURES
from evidence.arguments import parse
from pointpred import EventColumns
from pointpred.datasets import sample
from pointpred.live.devtools import drive_mouse
from pointpred.records import FloatArray
from pointpred_server.demo import write_demo
from tests.hosts import file_host
from tests.server import page_browser
from tests.server.page_browser import Visitor

Point = tuple[float, float]

WINDOW = 1000, 640
SHOWN = "#view-live .stage"
"""What is kept of the window, and a margin."""
MARGIN_PX = 12
WAY: tuple[int | Point, ...] = ((0.3, 0.2), 4, (0.62, 0.2), 1)
"""Where the movements begin and end: tiles, and places by their shares of the picture's size."""
MOVEMENTS = 15, 8, 3
"""Of the sample."""
RATE_HZ = 125.0
CLICK_S, PRESSED_S, REST_S = 0.12, 0.05, 0.5
"""From the last event of a movement to the click, how long that takes, and to the next movement."""
SETTLED_S, END_S = 0.5, 1.5
"""What is filmed after the last movement, and how long its last frame is shown."""
FRAME_S, COLOURS = 0.066, 256
STILL_S = 1.0
"""When the frame that does not move was shown."""
CURSOR = """(() => {
  const cursor = document.createElement("div");
  cursor.innerHTML = `<svg width="20" height="26" viewBox="0 0 20 26"><path d="M1 1v20l5-5 4 8 3-1.5-4-8h7z"
    fill="#000" stroke="#fff" stroke-width="1.5"/></svg>`;
  cursor.style = "position: fixed; left: 0; top: 0; pointer-events: none; z-index: 9";
  document.body.append(cursor);
  addEventListener("pointermove", ({ clientX: x, clientY: y, isTrusted }) => {
    if (isTrusted) cursor.style.transform = `translate(${x}px, ${y}px)`;
  }, true);
})()"""
"""Chromium draws no cursor into its pictures."""


def movement(rows: FloatArray, start: Point, end: Point) -> FloatArray:
    """Rows of events: a recorded movement, turned and scaled to begin and end here, RATE_HZ a second."""
    t, path = rows[:, 0] - rows[0, 0], rows[:, 1] + 1j * rows[:, 2]
    begin, stop = complex(*start), complex(*end)
    path = begin + (path - path[0]) * (stop - begin) / (path[-1] - path[0])
    reported = np.diff(np.floor(RATE_HZ * t), append=np.inf) > 0
    events = np.full((len(rows), 6), np.nan)
    events[:, :3], events[:, 5] = np.column_stack([t, path.real, path.imag]), 0.0
    return events[reported]


def planned(picture: Sequence[float], tiles: Sequence[Sequence[float]]) -> EventColumns:
    """All movements, with a click at each tile; of the picture and its tiles left, top, width and height."""
    left, top, width, height = picture
    centres = [(x + 0.5 * across, y + 0.5 * down) for x, y, across, down in tiles]
    way = [
        centres[one - 1] if isinstance(one, int) else (left + one[0] * width, top + one[1] * height)
        for one in WAY
    ]
    recorded, events, began = sample(), list[FloatArray](), 0.0
    for number, (start, end) in zip(MOVEMENTS, pairwise(way), strict=True):
        moved = movement(recorded.rows(number).table, start, end)
        moved[:, 0] += began
        events.append(moved)
        began = moved[-1, 0] + REST_S
        if end in centres:
            click = moved[[-1, -1]]
            click[:, 0] += CLICK_S, CLICK_S + PRESSED_S
            click[0, 5] = 1.0
            events.append(click)
    return EventColumns(np.vstack(events))


def filmed(visitor: Visitor, protocol: CDPSession) -> list[tuple[float, Image.Image]]:
    """What Chromium shows during the movements, with times in s."""
    frames: list[tuple[float, bytes]] = []

    def keep(frame: dict[str, Any]) -> None:
        frames.append((frame["metadata"]["timestamp"], base64.b64decode(frame["data"])))
        protocol.send("Page.screencastFrameAck", {"sessionId": frame["sessionId"]})

    picture = visitor.corner("#live-picture")
    tiles = [visitor.corner(f"#live-links button:nth-child({i})") for i in range(1, 6)]
    events = planned(picture, tiles)
    visitor.mouse("mouseMoved", float(events.x[0]), float(events.y[0]))
    visitor.page.wait_for_timeout(1000 * REST_S)
    hand = threading.Thread(target=drive_mouse, args=(visitor.hand, events))
    protocol.on("Page.screencastFrame", keep)
    protocol.send("Page.startScreencast", {"format": "png"})
    hand.start()
    while hand.is_alive():
        visitor.page.wait_for_timeout(10)  # ms; frames are heard meanwhile
    visitor.page.wait_for_timeout(1000 * SETTLED_S)
    protocol.send("Page.stopScreencast")
    left, top, width, height = visitor.corner(SHOWN)
    box = (left - MARGIN_PX, top - MARGIN_PX, left + width + MARGIN_PX, top + height + MARGIN_PX)
    began = frames[0][0]
    return [(t - began, Image.open(io.BytesIO(data)).convert("RGB").crop(box)) for t, data in frames]


def thinned(frames: Sequence[tuple[float, Image.Image]]) -> tuple[list[Image.Image], list[int]]:
    """The frames of a slower picture, and how long each is shown, ms."""
    kept = [frames[0]]
    for t, image in frames:
        if t - kept[-1][0] >= FRAME_S:
            kept.append((t, image))
    durations = np.diff([t for t, _ in kept], append=kept[-1][0] + END_S)
    return [image for _, image in kept], np.round(1000 * durations).astype(int).tolist()


def few_colours(images: Sequence[Image.Image]) -> list[Image.Image]:
    """The same in COLOURS of all of them: lossless is then smaller than lossy, and letters stay sharp."""
    some = images[:: max(1, len(images) // 12)]
    sheet = Image.new("RGB", (some[0].width, some[0].height * len(some)))
    for place, image in enumerate(some):
        sheet.paste(image, (0, place * image.height))
    palette = sheet.quantize(COLOURS, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
    return [image.quantize(palette=palette, dither=Image.Dither.NONE).convert("RGB") for image in images]


def main() -> None:
    """Film the page, and write both pictures."""
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        (page_folder := scratch / "page").mkdir()
        write_demo(page_folder)
        with file_host(page_folder) as origin, page_browser.visitor(scratch / "profile", WINDOW) as visitor:
            visitor.prefer(color_scheme="light")
            visitor.open(f"{origin}/index.html")
            visitor.wait("document.querySelector('#live-card-0 .connection').dataset.state === 'open'")
            visitor.value(CURSOR)
            visitor.value(f"scrollTo(0, document.querySelector('{SHOWN}').offsetTop - {2 * MARGIN_PX})")
            frames = filmed(visitor, visitor.page.context.new_cdp_session(visitor.page))
    images, durations = thinned(frames)
    images = few_colours(images)
    images[0].save(
        FIGURES / "live.webp",
        save_all=True,
        append_images=images[1:],
        duration=durations,
        loop=0,
        lossless=True,
        quality=80,
        method=4,
        kmin=len(images),
        kmax=len(images) + 1,  # only the first frame is whole
    )
    still = min(frames, key=lambda frame: abs(frame[0] - STILL_S))[1]
    still.save(FIGURES / "live.png", optimize=True)
    for name in ("live.webp", "live.png"):
        print(f"{FIGURES / name}: {(FIGURES / name).stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    parse(__doc__)
    main()
