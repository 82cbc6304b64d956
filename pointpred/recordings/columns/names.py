"""The usual column names of time, position, user, trial, button and target."""

from __future__ import annotations

import re
from collections.abc import Sequence

import msgspec

from pointpred.recordings.reading import KEYS


def _words(*lines: str) -> tuple[str, ...]:
    return tuple(" ".join(lines).split())


TOKENS = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[^\W\d_A-Z]+|\d+")
"""The words of a name, separated by capitals, marks and blanks."""
TIME_UNITS = {
    word: unit
    for unit, words in {
        "s": "s sec secs second seconds",
        "ms": "ms msec msecs millis millisecond milliseconds",
        "us": "us µs μs usec usecs micros microsecond microseconds",
        "ns": "ns nsec nsecs nanos nanosecond nanoseconds",
    }.items()
    for word in words.split()
}
OTHER_UNITS = frozenset(
    _words("min mins minute minutes h hr hrs hour hours day days frame frames tick ticks")
)
"""Words at the end of a clock's name for units that are not supported."""
PIXELS = frozenset(("px", "pix", "pixel", "pixels"))
INTERVALS = frozenset(_words("interval intervals delta diff difference duration dt between"))
"""Words in the name of a column of intervals, which is not a clock."""
TIMES = _words(
    "t time timestamp ts elapsed timestamps times elapsedtime timeelapsed datetime epoch unixtime mousetime",
    "eventtime timearray tarray timelist tlist timetrajectory",
)
XS = _words(
    "x xpos posx xposition positionx mousex xmouse mouseposx cursorx xcursor cursorposx pointerx clientx",
    "pagex screenx px xcoord coordx xcoordinate coordinatex xs xarray arrayx xlist listx",
    "xtrajectory trajectoryx xvalues xvals",
)
STUDY = ("block", "session", "run", "condition", "phase")
COUNTS = frozenset(_words("id number num no nr index idx name count"))
"""Words beside the one that names the counted thing."""
NUMBERED = COUNTS - {"name", "count"}
"""Those that tell one of several."""
CLOCKS = ("t", "ts", "clock")
VAGUE = ("state",)
"""Names of columns that hold buttons only if their cells are words for buttons."""
USUAL = {
    "user": "user users userid participant participantid participantnr subject subjectid subjectnr "
    "subjectnumber subj subjid sid pid ppid",
    "trial": "trial trialid trialnumber trialnum trialno trialnr trialindex ntrial numtrial",
    "buttons": "buttons button pressed state mousedown buttonstate mousebutton mousebuttons",
    "target_x": "targetx goalx targetposx targetxpos xtarget",
    "target_y": "targety goaly targetposy targetypos ytarget",
    "target_w": "targetw targetwidth targetsize targetdiameter wtarget",
    "dx": "dxcounts",
    "dy": "dycounts",
}


class Guess(msgspec.Struct, frozen=True):
    """The columns with a usual name: ``columns`` field -> the only one, ``choices`` field -> several."""

    columns: dict[str, str]
    choices: dict[str, tuple[str, ...]]

    @property
    def best(self) -> dict[str, str]:
        """One column per field, the first of several: for display only."""
        return {field: several[0] for field, several in self.choices.items()} | self.columns


def user_column(names: Sequence[str], usual: Sequence[str]) -> dict[str, str]:
    """The column of users: the first of ``usual`` among ``names``, or one with a usual name; or none.

    >>> user_column(["group", "participant"], ["subject", "participant"]), user_column(["x"], [])
    ({'user': 'participant'}, {})
    """
    column = next((name for name in usual if name in names), None) or guess(names).best.get("user")
    return {} if column is None else {"user": column}


def words_of(name: str) -> list[str]:
    """The words of a column's name in small letters.

    >>> words_of("mouseX"), words_of("Time [ms]"), words_of("x_px")
    (['mouse', 'x'], ['time', 'ms'], ['x', 'px'])
    """
    return [word.lower() for word in TOKENS.findall(name)]


def unit_in(name: str) -> str | None:
    """The unit of time that a column's name ends with: s, ms, us or ns.

    >>> unit_in("t_ms"), unit_in("Time (s)"), unit_in("ts")
    ('ms', 's', None)
    """
    words = words_of(name)
    alone = len(words) == 1 and len(words[0]) < 3 and words != ["ms"]
    return None if alone or not words else TIME_UNITS.get(words[-1])


def has_other_unit(name: str) -> bool:
    """Whether a column's name ends with a unit of time that is not read.

    >>> has_other_unit("time_min"), has_other_unit("frame_time")
    (True, False)
    """
    return not OTHER_UNITS.isdisjoint(words_of(name)[-1:])


def guess(names: Sequence[str]) -> Guess:
    """The usual names among ``names``; x and y count only as a pair, as ``clientX`` and ``clientY``.

    If t, x and y are not all present, the only group that contains them is used, as ``samples.t`` and so on.

    >>> guess(["subject", "time_ms", "xpos", "ypos"]).columns
    {'user': 'subject', 't': 'time_ms', 'x': 'xpos', 'y': 'ypos'}
    >>> guess(["trial", "samples.t", "samples.x", "samples.y", "start.x", "start.y"]).columns
    {'trial': 'trial', 't': 'samples.t', 'x': 'samples.x', 'y': 'samples.y'}
    """
    usual = _usual(names)
    if {"t", "x", "y"} <= {*usual.columns, *usual.choices}:
        return usual
    groups: dict[str, list[str]] = {}
    for name in names:
        prefix, dot, last = name.rpartition(".")
        groups.setdefault(prefix + dot, []).append(last)
    parts = {prefix: _usual(some).columns for prefix, some in groups.items() if prefix}
    whole = [prefix for prefix, part in parts.items() if {"t", "x", "y"} <= part.keys()]
    if len(whole) != 1:
        return Guess(usual.columns | _lone(names), usual.choices)
    taken = {field: whole[0] + parts[whole[0]][field] for field in ("t", "x", "y")}
    choices = {field: some for field, some in usual.choices.items() if field not in taken}
    return Guess(usual.columns | taken, choices)


def _usual(names: Sequence[str]) -> Guess:
    matches: dict[str, list[str]] = {
        field: _in_order(names, words.split(), PIXELS) for field, words in USUAL.items()
    }
    for field in KEYS:
        matches[field] = matches[field] or _numbered(names, USUAL[field].split())
    matches["t"] = [name for name in names if _plain(name, frozenset()) in ("ms", "msec", "millis")]
    matches["t"] = _in_order(names, TIMES, frozenset(TIME_UNITS)) + matches["t"]
    pairs = _pairs(names)
    matches["x"], matches["y"] = [pair[0] for pair in pairs], [pair[1] for pair in pairs]
    return Guess(
        {field: several[0] for field, several in matches.items() if len(several) == 1},
        {field: tuple(several) for field, several in matches.items() if len(several) > 1},
    )


def similar_names(names: Sequence[str]) -> dict[str, str]:
    """Columns that may be t, x and y although their names are not the usual ones, for display only.

    >>> similar_names(["gaze_time_at", "gaze_x_raw", "gaze_y_raw"])
    {'t': 'gaze_time_at', 'x': 'gaze_x_raw', 'y': 'gaze_y_raw'}
    """
    words = {name: words_of(name) for name in names if "target" not in name.lower()}
    times = [
        name
        for name, some in words.items()
        if any(word in CLOCKS or "time" in word or "stamp" in word for word in some)
        and not INTERVALS.intersection(some)
    ]
    fits = {
        "t": times,
        "x": [name for name, some in words.items() if "x" in some],
        "y": [name for name, some in words.items() if "y" in some],
    }
    return {field: some[0] for field, some in fits.items() if some}


def parts_of_study(names: Sequence[str]) -> list[str]:
    """The columns that divide a study: blocks, sessions, runs, conditions or phases, in this order.

    >>> parts_of_study(["phase", "blockNum", "session_id", "blocked"])
    ['blockNum', 'session_id', 'phase']
    """
    plain = {name: "".join(word for word in words_of(name) if word not in COUNTS) for name in names}
    return sorted((name for name in names if plain[name] in STUDY), key=lambda name: STUDY.index(plain[name]))


def _plain(name: str, units: frozenset[str]) -> str:
    """The words of a name joined, without a unit at its end."""
    words = words_of(name)
    return "".join(words[:-1] if len(words) > 1 and words[-1] in units else words)


def _in_order(names: Sequence[str], usual: Sequence[str], units: frozenset[str]) -> list[str]:
    """The usual names among ``names``, in the order of ``usual``."""
    ranked = [(usual.index(plain), name) for name in names if (plain := _plain(name, units)) in usual]
    return [name for _, name in sorted(ranked, key=lambda one: one[0])]


def _numbered(names: Sequence[str], usual: Sequence[str]) -> list[str]:
    """The names of which all words but an ``id``, ``idx`` and the like are a usual name."""
    return [name for name in names if "".join(w for w in words_of(name) if w not in NUMBERED) in usual]


def _lone(names: Sequence[str]) -> dict[str, str]:
    """The only x or y without a partner among the names."""
    ys = [word.replace("x", "y") for word in XS]
    matches = {"x": _in_order(names, XS, PIXELS), "y": _in_order(names, ys, PIXELS)}
    return {field: some[0] for field, some in matches.items() if len(some) == 1}


def _pairs(names: Sequence[str]) -> list[tuple[str, str]]:
    """The columns x and y that belong together: their names differ in one letter."""
    ys = {_plain(name, PIXELS): name for name in reversed(names)}
    pairs = [(name, ys.get(_plain(name, PIXELS).replace("x", "y"))) for name in _in_order(names, XS, PIXELS)]
    return [(x, y) for x, y in pairs if y is not None]
