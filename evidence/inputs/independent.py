"""Each layout of ``measure`` read again, in a few lines that share nothing with the importers.

A function takes a file and what ``inputs.toml`` says of it, and returns a table with a row a sample in the
file's order: ``user``, ``trial`` (empty: none), ``row`` (the number by which messages name it), ``t`` in
seconds, ``x`` and ``y`` in px, y down.
"""

from __future__ import annotations

import json
import re
import struct
from collections.abc import Callable, Sequence
from decimal import Decimal
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import scipy.io

COLUMNS = ["user", "trial", "row", "t", "x", "y"]
PAUSE_S = 0.3


def delimited(path: Path, *, t: str, x: str, y: str, per_second: float | str, **options: Any) -> pd.DataFrame:
    """Plain text, a row a sample; ``per_second`` is "iso" where the cells are dates.

    A row with a cell in the column ``further`` is too long and none; ``pair`` holds x and y in one cell.
    """
    user, trial, cut, further, pair = (
        options.pop(name, "") for name in ("user", "trial", "cut", "further", "pair")
    )
    options |= {"header": None} if "names" in options else {}
    table = pd.read_csv(path, dtype=str, **options)
    if pair:
        table[[x, y]] = table[pair].str.extract(r"(-?[\d.]+), *(-?[\d.]+)")
    if further:
        table.loc[table[further].notna(), [x, y]] = np.nan
    return _samples(path, table, (t, x, y), per_second, user, trial, cut)


def pairs(path: Path, *, per_second: float) -> pd.DataFrame:
    """A hook's log: what happened; when; where as ``(x, y)``, or the name of a key. A late row is sorted."""
    table = pd.read_csv(path, sep=";", names=["what", "t", "place"])
    places = table["place"].str.extract(r"\((-?\d+), (-?\d+)\)").astype(float)
    rows = pd.DataFrame({"row": table.index, "t": table["t"] / per_second, "x": places[0], "y": places[1]})
    rows["user"], rows["trial"] = _stem(path), ""
    rows["part"] = (rows["t"].diff() < -1.0).cumsum()
    rows = rows.assign(what=table["what"]).sort_values(["part", "t"], kind="stable", ignore_index=True)
    held = [
        rows["what"].map({f"mouse {button} down": True, f"mouse {button} up": False}).ffill().eq(True)
        for button in ("left", "right")
    ]
    placed = rows["x"].notna()
    rows.loc[placed, "trial"] = _at_clicks((held[0] | held[1])[placed], rows["part"][placed])
    return rows[COLUMNS]


def pynput(path: Path) -> pd.DataFrame:
    """A log of pynput's listeners without releases: a press lasts for its line; keys and wheel are none."""
    text = path.read_text(encoding="cp1252")
    line = re.compile(r"^(.{19}),(\d{3}): Mouse (moved to|clicked at) \((\d+), (\d+)\)", re.MULTILINE)
    rows = pd.DataFrame(line.findall(text), columns=["date", "ms", "what", "x", "y"])
    rows["t"] = (pd.to_datetime(rows["date"]) - pd.Timestamp(0)).dt.total_seconds() + rows["ms"].astype(
        int
    ) / 1e3
    rows["t"] -= rows["t"][0]
    rows["trial"] = _at_clicks(rows["what"] == "clicked at", 0)
    rows = rows.assign(row=rows.index, user=_stem(path))
    return rows[COLUMNS].astype({"x": float, "y": float})


def rrweb(path: Path) -> pd.DataFrame:
    """rrweb: positions of the mouse, each with an offset, and presses and releases, sorted by time."""
    parts = []
    for event in json.loads(path.read_text(encoding="utf-8")):
        data, time = event["data"], event["timestamp"]
        if event["type"] == 3 and data["source"] == 1:
            parts += [(time + one["timeOffset"], one["x"], one["y"], None) for one in data["positions"]]
        elif event["type"] == 3 and data["source"] == 2 and data["type"] in (0, 1):
            parts.append((time, data["x"], data["y"], data["type"] == 1))
    rows = pd.DataFrame(parts, columns=["t", "x", "y", "down"]).sort_values(
        "t", kind="stable", ignore_index=True
    )
    rows["trial"] = _at_clicks(rows["down"].ffill().eq(True), 0)
    rows = rows.assign(row=rows.index, user=_stem(path), t=(rows["t"] - rows["t"][0]) / 1000)
    return rows[COLUMNS].astype({"x": float, "y": float})


def tracks(
    path: Path, *, t: str, x: str, y: str, per_second: float, points: str = "", y_up: bool = False
) -> pd.DataFrame:
    """JSON: an array of objects, a trial each, of lists; or of one list ``points``, of lists or objects."""
    parts = []
    for row, one in enumerate(json.loads(path.read_text(encoding="utf-8"))):
        if points and points not in one:
            continue
        track = pd.DataFrame(one[points] if points else {name: one[name] for name in (t, x, y)})
        track = track.rename(columns=str)[[t, x, y]].set_axis(["t", "x", "y"], axis=1)
        track["t"] = (track["t"] - track["t"].iloc[0]) / per_second
        parts.append(track.assign(y=-track["y"] if y_up else track["y"], trial=str(row), row=row))
    rows = pd.concat(parts, ignore_index=True)
    return rows.assign(user=_stem(path))[COLUMNS].astype({"x": float, "y": float})


def objects(
    path: Path, *, t: str, x: str, y: str, per_second: float, cut: str = "", **button: Any
) -> pd.DataFrame:
    """JSON: an array of objects, one a sample; cut at clicks by a ``button``: column, press and release."""
    table = pd.DataFrame(json.loads(path.read_text(encoding="utf-8")))
    rows = _samples(path, table, (t, x, y), per_second, "", "", cut)
    if button:
        happened = table[button["column"]].map({button["press"]: True, button["release"]: False})
        placed = rows["x"].notna()
        rows.loc[placed, "trial"] = _at_clicks(happened.ffill().eq(True)[placed], 0)
    return rows


def lists(
    path: Path, *, t: str, x: str, y: str, per_second: float, user: str = "", trial: str = "", sep: str = ","
) -> pd.DataFrame:
    """Delimited text, a row a trial: its cells hold lists, with or without brackets."""
    table = pd.read_csv(path, dtype=str, sep=sep, keep_default_na=False)
    parts = []
    for row, cells in enumerate(table.to_dict("records")):
        series = [_numbers(str(cells[name])) for name in (t, x, y)]
        part = pd.DataFrame(dict(zip("txy", series, strict=True)))
        part["user"] = cells[user] if user else _stem(path)
        part["trial"], part["row"] = cells[trial] if trial else str(row), row
        part["t"] = (part["t"] - part["t"].iloc[:1].sum()) / per_second  # stamps since 1970 keep their digits
        parts.append(part)
    return pd.concat(parts, ignore_index=True)[COLUMNS]


def mousetrap(path: Path) -> pd.DataFrame:
    """OpenSesame: a row a trial, ``timestamps_``, ``xpos_`` and ``ypos_`` of one or more items."""
    table = pd.read_csv(path, dtype=str, keep_default_na=False)
    items = [name.removeprefix("timestamps_") for name in map(str, table) if name.startswith("timestamps_")]
    parts = []
    for row, cells in enumerate(table.to_dict("records")):
        for item in items:
            named = ("timestamps_", "xpos_", "ypos_")
            series = [_numbers(cells[prefix + item]) for prefix in named]
            part = pd.DataFrame(dict(zip("txy", series, strict=True)))
            part["user"], part["row"] = cells.get("subject_nr", _stem(path)), row
            part["trial"] = str(row) if len(items) == 1 else f"{row} {item}"
            parts.append(part)
    rows = pd.concat(parts, ignore_index=True)
    return rows.assign(t=rows["t"] / 1000)[COLUMNS]


def psychopy(path: Path, *, height: float) -> pd.DataFrame:
    """PsychoPy in units of the window's height: y up becomes y down."""
    table = pd.read_csv(path, dtype=str).dropna(subset=["mouse.time"])
    table = table.assign(row=table.index, trial=table.index.astype(str), user=table["participant"])
    for name, column in (("t", "mouse.time"), ("x", "mouse.x"), ("y", "mouse.y")):
        table[name] = table[column].map(_numbers)
    rows = table.explode(["t", "x", "y"], ignore_index=True).astype({"t": float, "x": float, "y": float})
    return rows.assign(x=rows["x"] * height, y=rows["y"] * -height)[COLUMNS]


def gofitts(path: Path) -> pd.DataFrame:
    """GoFitts: three lines a trial; participant, session, block, sequence and trial stand before ``t=``."""
    lines = [line.split(",") for line in path.read_text(encoding="utf-8").splitlines()[2:]]
    parts = []
    for at in range(0, len(lines) - 2, 3):
        key = lines[at]
        values = [
            pd.to_numeric(pd.Series(line[17:]).replace("", None).dropna()) for line in lines[at : at + 3]
        ]
        name = " ".join(key[place] for place in (3, 7, 8, 11))
        series = dict(zip("txy", values, strict=True))
        parts.append(pd.DataFrame(series | {"user": key[1], "trial": name, "row": at}))
    rows = pd.concat(parts, ignore_index=True)
    return rows.assign(t=rows["t"] / 1000)[COLUMNS]


def balabit(path: Path, *, user: str, per_second: float = 1) -> pd.DataFrame:
    """Balabit: from the release of a button to the next press; wheel rows belong to no trial."""
    table = pd.read_csv(path, skipinitialspace=True)
    table = table.assign(row=table.index, t=table["client timestamp"] / per_second, user=user)
    moved = table[table["button"] != "Scroll"].copy()
    down = pd.DataFrame(
        {
            name: moved["state"].where(moved["button"] == name).ffill().isin(["Pressed", "Drag"])
            for name in ("Left", "Right", "Middle")
        }
    ).any(axis=1)
    table["trial"] = _at_clicks(down, 0).reindex(table.index, fill_value="")
    return table[COLUMNS].astype({"x": float, "y": float})


def evemu(path: Path) -> pd.DataFrame:
    """evemu: the counts between two SYN_REPORT are one sample; frames of the wheel alone are none."""
    line = re.compile(r"^E: (\d+)\.(\d{6}) ([0-9a-f]{4}) ([0-9a-f]{4}) (-?\d+)", re.MULTILINE)
    matches = line.findall(path.read_text(encoding="utf-8"))
    events = pd.DataFrame(matches, columns=["s", "us", "type", "code", "value"]).astype({"value": int})
    report = (events["type"] == "0000") & (events["code"] == "0000")
    events["frame"] = report.shift(fill_value=False).cumsum()
    motion = events["type"] == "0002"
    button = (events["type"] == "0001") & events["code"].between("0110", "0116")
    for axis, code in (("x", "0000"), ("y", "0001")):
        events[axis] = events["value"].where(motion & (events["code"] == code), 0)
    events["use"] = (motion & events["code"].isin(["0000", "0001"])) | button
    events["row"] = events.index
    events["t"] = (events["s"].astype(int) - int(events["s"][0])) + events["us"].astype(int) / 1e6
    frames = events.groupby("frame").agg({"row": "first", "t": "last", "x": "sum", "y": "sum", "use": "any"})
    used = frames[frames["use"]].cumsum()[["x", "y"]].astype(float)
    rows = frames[["row", "t"]].join(used).assign(user="unknown", trial="").reset_index(drop=True)
    rows.loc[rows["x"].notna(), "trial"] = _cut(rows.dropna(), "bursts")
    return rows[COLUMNS]


def touches(path: Path, *, line: str, base: int) -> pd.DataFrame:
    """A touch screen by evtest or getevent: the first contact until it is lifted, which is a sample more.

    ``line`` finds the stamp, the code and the value, in the ``base``, of an event.
    """
    events = re.findall(line, path.read_text(encoding="utf-8"), re.MULTILINE)
    parts, listed = [], []
    current, place, number, first, part = {}, None, None, 0, 0
    for row, (stamp, code, value) in enumerate(events):
        if code in ("ABS_MT_TRACKING_ID", "ABS_MT_POSITION_X", "ABS_MT_POSITION_Y"):
            current[code[7:]] = int(value, base)
        elif code == "SYN_MT_REPORT":
            listed.append(current)
            current = {}
        elif code == "SYN_REPORT":
            there = {
                one["TRACKING_ID"]: one for one in listed or [current] if one.get("TRACKING_ID", -1) >= 0
            }
            current = {} if listed else current
            new = there.get(number) if number is not None else None
            lifted = number is not None and new is None
            if new is None and there and not lifted:
                number, new = next(iter(there.items()))
            if lifted or (new is not None and (new["POSITION_X"], new["POSITION_Y"]) != place):
                place = place if lifted else (new["POSITION_X"], new["POSITION_Y"])
                parts.append((first, float(stamp), *place, part))
            if lifted:
                number, place, part = None, None, part + 1
            listed, first = [], row + 1
    rows = pd.DataFrame(parts, columns=["row", "t", "x", "y", "part"]).assign(user="unknown", trial="")
    rows["trial"] = _cut(rows, "bursts")
    return rows[COLUMNS].astype({"x": float, "y": float})


def hid(path: Path, *, layout: str, motion: Sequence[int]) -> pd.DataFrame:
    """hid-recorder: reports of report ID 1, unpacked by ``layout``, x and y at the places ``motion``."""
    parts = []
    reports = [line.split() for line in path.read_text(encoding="utf-8").splitlines() if line[:2] == "E:"]
    for row, (_, stamp, _, *words) in enumerate(reports):
        values = struct.unpack(layout, bytes.fromhex("".join(words))) if words[0] == "01" else None
        parts.append((row, float(stamp), *([values[place] for place in motion] if values else [None, None])))
    rows = pd.DataFrame(parts, columns=["row", "t", "x", "y"]).assign(user="unknown", trial="")
    rows[["x", "y"]] = rows[["x", "y"]].cumsum()
    rows.loc[rows["x"].notna(), "trial"] = _cut(rows.dropna(), "bursts")
    return rows[COLUMNS]


def matlab(path: Path, *, struct_name: str, per_second: float, cut: str) -> pd.DataFrame:
    """MATLAB: the vectors t, x and y of one struct."""
    struct = scipy.io.loadmat(path, squeeze_me=True)[struct_name]
    table = pd.DataFrame({name: struct[name].item() for name in "txy"})
    return _samples(path, table, ("t", "x", "y"), per_second, "", "", cut)


def xdf(path: Path, *, sample: str, channels: Sequence[int]) -> pd.DataFrame:
    """XDF: the samples of stream 0, unpacked by ``sample``, x and y at the places ``channels``."""
    data, at, parts, last = path.read_bytes(), 4, [], 0.0
    while at < len(data):
        width = data[at]
        size = int.from_bytes(data[at + 1 : at + 1 + width], "little")
        chunk = data[at + 1 + width : at + 1 + width + size]
        at += 1 + width + size
        if chunk[:2] == b"\x03\x00" and chunk[2:6] == bytes(4):
            place = 7 + chunk[6]
            while place < len(chunk):
                stamped = chunk[place] == 8
                last = struct.unpack_from("<d", chunk, place + 1)[0] if stamped else last + 0.1
                place += 9 if stamped else 1
                values = struct.unpack_from(sample, chunk, place)
                place += struct.calcsize(sample)
                parts.append((last, *(float(values[channel]) for channel in channels)))
    table = pd.DataFrame(parts, columns=["t", "x", "y"])
    return _samples(path, table, ("t", "x", "y"), 1.0, "", "", "whole")


LAYOUTS: dict[str, Callable[..., pd.DataFrame]] = {
    layout.__name__: layout
    for layout in (
        delimited,
        pairs,
        pynput,
        rrweb,
        tracks,
        objects,
        lists,
        mousetrap,
        psychopy,
        gofitts,
        balabit,
        evemu,
        touches,
        hid,
        matlab,
        xdf,
    )
}


def _stem(path: Path) -> str:
    """What a user is called where the file names none."""
    return Path(path.name.removesuffix(".gz")).stem


def _samples(
    path: Path,
    table: pd.DataFrame,
    names: tuple[str, str, str],
    per_second: float | str,
    user: str,
    trial: str,
    cut: str,
) -> pd.DataFrame:
    """A row a sample: keys as words, numbers as numbers; a stream is cut as ``cut`` says."""
    rows = pd.DataFrame({"row": np.arange(len(table))})
    rows["x"], rows["y"] = pd.to_numeric(table[names[1]]), pd.to_numeric(table[names[2]])
    if per_second == "iso":
        times = pd.to_datetime(table[names[0]], format="ISO8601")
        rows["t"] = (times - times.iloc[0]).dt.total_seconds()
    else:
        exact = table[names[0]].map(lambda cell: Decimal(str(cell)))
        rows["t"] = (exact - exact.iloc[0]).map(float) / float(per_second)
    rows["user"] = table[user].fillna("").str.strip() if user else _stem(path)
    rows["trial"] = table[trial].fillna("").str.strip() if trial else ""
    if trial:
        rows["trial"] = _restarted(rows)
    if cut:
        rows.loc[rows[["t", "x", "y"]].notna().all(axis=1), "trial"] = _cut(rows.dropna(), cut)
    return rows[COLUMNS].astype({"t": float, "x": float, "y": float})


def _restarted(rows: pd.DataFrame) -> pd.Series:
    """The trial of each row; a run of rows that begins before the end of the last is a trial of its own."""
    run = (rows[["user", "trial"]] != rows[["user", "trial"]].shift()).any(axis=1).cumsum()
    spans = rows.groupby(run).agg(
        user=("user", "first"), trial=("trial", "first"), begin=("t", "first"), end=("t", "last")
    )
    same = spans.groupby(["user", "trial"])
    number = (spans["begin"] < same["end"].shift()).groupby([spans["user"], spans["trial"]]).cumsum()
    again = (number > 0) & (spans["trial"] != "")
    named = spans["trial"].where(~again, spans["trial"] + " (" + (number + 1).astype(str) + ")")
    return run.map(named)


def _cut(rows: pd.DataFrame, how: str) -> pd.Series:
    """The trial of each row of a stream: anew where time goes back and, in bursts, after a pause."""
    named = pd.Series("", index=rows.index)
    for _, mine in rows.groupby("user", sort=False):
        part = (mine["t"].diff() < 0).cumsum()
        part = part + mine["part"] if "part" in mine else part  # a contact each
        pieces = []
        for number, some in mine.groupby(part):
            moves = some[(some["x"].diff() != 0) | (some["y"].diff() != 0)]
            burst = (moves["t"].diff() > PAUSE_S).cumsum().reindex(some.index)
            inside = burst.ffill().where(burst.ffill() == burst.bfill())
            inside = inside if how == "bursts" else pd.Series(0.0, index=some.index)
            pieces.append(inside + number * (len(rows) + 1.0))
        named.update(_numbered(pd.concat(pieces)))
    return named


def _at_clicks(down: pd.Series, part: pd.Series | int) -> pd.Series:
    """The trial of each row: from a release, or where a ``part`` begins, to the next press."""
    keys = pd.Series(part, index=down.index)
    before = down.groupby(keys).shift(fill_value=False)
    press, release = down & ~before, ~down & before
    piece = (release | (keys.diff() > 0)).cumsum().where(~down | press)
    ended = piece.groupby(keys).transform(lambda some: some <= some[press.reindex(some.index)].max())
    return _numbered(piece.where(ended))


def _numbered(piece: pd.Series) -> pd.Series:
    """Pieces of two and more rows as 0, 1, ... in their order, as words; empty where there is none."""
    large = piece.groupby(piece).transform("size") >= 2
    codes, _ = pd.factorize(piece.where(large))
    return pd.Series(codes, index=piece.index).map(lambda code: "" if code < 0 else str(code))


def _numbers(cell: str) -> list[float]:
    """The numbers of a list in a cell; nothing between two commas is NaN."""
    inner = cell.strip().strip("[]").removesuffix(",")
    if not inner.strip() or inner.strip() in ("NA", "None"):
        return []
    return [float(word) if word.strip() else float("nan") for word in inner.split(",")]
