"""The records that flow: an event in, a motion between, a prediction out; as rows of floats, and as tables.

Each field is declared once, with its unit and bounds and what it is on the wire and in files: rows, columns,
checks, the wire's forms and the names of columns are made from that. Positions are screen pixels (y grows
downwards), time is seconds on any clock that does not run backwards, motor quantities are metres and seconds.
Zero is data everywhere; only ``None`` means "not there", and is NaN in a row. Laws, tables and binary frames
hold rows, users hold records.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import floor, inf, nan
from types import NoneType
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    Literal,
    NamedTuple,
    Self,
    get_args,
    get_type_hints,
)

import msgspec
import numpy as np
from numpy.typing import ArrayLike, NDArray

from pointpred.columns import Columns, columns_of_frame, numbers_of
from pointpred.compiled import law
from pointpred.errors import EventError, EventOrderError
from pointpred.parameter import is_number, warn_of_milliseconds
from pointpred.regions import Region, probability, region_of

if TYPE_CHECKING:
    import pandas as pd

FloatArray = NDArray[np.float64]
FloatTable = NDArray[np.float64]
IntArray = NDArray[np.int64]
IntTable = NDArray[np.int64]
BoolArray = NDArray[np.bool_]
BoolTable = NDArray[np.bool_]
"""Arrays of one dimension, tables of two: as arguments of laws, contiguous."""

Phase = Literal["still", "ballistic", "corrective"]
PHASES: tuple[Phase, ...] = ("still", "ballistic", "corrective")
"""Phases in the order of their codes in columns and binary frames."""

LATEST_S = 1e11
"""Bound on the magnitude of a time: seconds of any clock fit, milliseconds since 1970 are a mistaken unit."""
LARGEST = 1e9
"""Bound on the magnitude of positions (px), counts and buttons: beyond it arithmetic means nothing."""
MOTION_MOST = 1e300
"""Bound on the magnitude of the numbers of a motion: sums and squares' roots of them are finite."""
NORMAL = float("nan")
"""The tail of a normal law in columns, frames and laws; records say ``None``."""
METRES_PER_INCH = 0.0254
CPI, DPI = (1.0, 1e6), (1.0, 1e5)
"""Bounds on the counts per inch of a device and the pixels per inch of a screen."""
F8 = "<f8"
ROUNDING_S = 1e-6
"""Spans of time that differ by less are compared as equal: no rule may hang on how a clock is rounded."""


class Field(msgspec.Struct, frozen=True):
    """What is said of a field, once: its unit, the closed bounds of its values, its other forms.

    ``packed``: its type in a binary frame, ``since``: the first version of the wire that has it; ``most``:
    the largest value on the wire, where that is less than ``high``; ``column``: its name in pointpred's own
    files. "" where it is not there.
    """

    unit: str
    low: float = -inf
    high: float = inf
    whole: bool = False
    packed: str = ""
    since: int = 1
    most: float = inf
    column: str = ""
    name: str = ""
    optional: bool = False

    def fault(self, value: Any) -> str:
        """What is wrong with a value, in words; "" for nothing."""
        if value is None and self.optional:
            return ""
        if not is_number(value):
            return f"{self.name} must be a number, received {value!r}"
        if not self.low <= value <= self.high:
            return f"{self.name} must lie in [{self.low:g}, {self.high:g}], received {value!r}"
        if self.whole and value != int(value):
            return f"{self.name} must be a whole number, received {value!r}"
        return ""

    @property
    def json(self) -> Any:
        """The type of its values in JSON."""
        number: Any = int if self.whole else float
        kind: Any = Annotated[number, msgspec.Meta(ge=number(self.low), le=number(min(self.high, self.most)))]
        return kind | None if self.optional else kind


def fields_of(record: type) -> tuple[Field, ...]:
    """The declarations of a record's fields, in their order; a field of several numbers has one for each."""
    return tuple(
        msgspec.structs.replace(
            field, name=field.name or name, optional=NoneType in get_args(hint.__origin__)
        )
        for name, hint in get_type_hints(record, include_extras=True).items()
        for field in hint.__metadata__
    )


class PointerEvent(msgspec.Struct, frozen=True):
    """One report of a pointing device.

    ``t`` s; ``x`` and ``y`` cursor position in px; ``dx`` and ``dy`` device counts since the previous event,
    ``None`` where the source has none; ``buttons`` pressed, as in W3C pointer events (bit 0: primary).
    """

    t: Annotated[float, Field("s", -LATEST_S, LATEST_S, packed=F8, column="t_s")]
    x: Annotated[float, Field("px", -LARGEST, LARGEST, packed=F8, column="x_px")]
    y: Annotated[float, Field("px", -LARGEST, LARGEST, packed=F8, column="y_px")]
    dx: Annotated[float | None, Field("counts", -LARGEST, LARGEST, packed="<i2", column="dx_counts")] = None
    dy: Annotated[float | None, Field("counts", -LARGEST, LARGEST, packed="<i2", column="dy_counts")] = None
    buttons: Annotated[int, Field("", 0, LARGEST, True, packed="<u2", most=65535, column="buttons")] = 0


class Motion(msgspec.Struct, frozen=True):
    """What a differentiator knows after an event.

    ``x`` and ``y`` cursor px; ``vx vy`` m/s and ``ax ay`` m/s^2 of the hand; ``settled`` once the estimate
    has seen enough samples since its last restart; ``start`` when a movement starts at this sample;
    ``counts`` when the motor motion comes from device counts rather than from the cursor.
    """

    t: Annotated[float, Field("s", -MOTION_MOST, MOTION_MOST)]
    x: Annotated[float, Field("px", -MOTION_MOST, MOTION_MOST)]
    y: Annotated[float, Field("px", -MOTION_MOST, MOTION_MOST)]
    vx: Annotated[float, Field("m/s", -MOTION_MOST, MOTION_MOST)]
    vy: Annotated[float, Field("m/s", -MOTION_MOST, MOTION_MOST)]
    ax: Annotated[float, Field("m/s^2", -MOTION_MOST, MOTION_MOST)]
    ay: Annotated[float, Field("m/s^2", -MOTION_MOST, MOTION_MOST)]
    settled: Annotated[bool, Field("")]
    start: Annotated[bool, Field("")] = False
    counts: Annotated[bool, Field("")] = False


class Prediction(msgspec.Struct, frozen=True):
    """Where a movement will end: ``x y`` px, seen from time ``t`` s.

    ``scale`` = (sxx, sxy, syy) px^2, the scale matrix of the endpoint's law, or ``None`` where the predictor
    claims no region. ``tail``: degrees of freedom of that law, a bivariate Student law; ``None``: the law is
    normal, and ``scale`` its covariance. ``phase`` of the movement at ``t``. ``remaining_s`` until arrival,
    ``remaining_spread`` the standard deviation of the logarithm of that; ``None``: not claimed.
    """

    t: Annotated[float, Field("s", packed=F8, column="t_s")]
    x: Annotated[float, Field("px", packed=F8, column="x_px")]
    y: Annotated[float, Field("px", packed=F8, column="y_px")]
    scale: Annotated[
        tuple[float, float, float] | None,
        Field("px^2", packed=F8, column="sxx_px2", name="sxx"),
        Field("px^2", packed=F8, column="sxy_px2", name="sxy"),
        Field("px^2", packed=F8, column="syy_px2", name="syy"),
    ]
    phase: Annotated[Phase, Field("", packed="<u1", column="phase")]
    remaining_s: Annotated[float | None, Field("s", packed=F8, column="remaining_s")]
    tail: Annotated[float | None, Field("", packed=F8, column="tail")] = None
    remaining_spread: Annotated[float | None, Field("", packed=F8, since=2, column="remaining_spread")] = None

    @property
    def covariance(self) -> tuple[float, float, float] | None:
        """(sxx, sxy, syy) px^2 of the endpoint, or ``None`` where no region is claimed.

        That of a Student law is ``scale`` tail / (tail - 2); with a tail up to 2 it has none.
        """
        if self.scale is None or self.tail is None:
            return self.scale
        if not self.tail > 2.0:
            return None
        wider = 1.0 / (1.0 - 2.0 / self.tail)
        sxx, sxy, syy = self.scale
        return wider * sxx, wider * sxy, wider * syy

    def region(self, level: float) -> Region | None:
        """The ellipse that holds the endpoint with probability ``level``, as the prediction claims.

        ``None`` where no region is claimed, the scale matrix has no inside, or the ellipse is too large for a
        finite number. Raises ParameterError for a level outside (0, 1).

        >>> prediction = Prediction(0.0, 300.0, 200.0, (400.0, 0.0, 100.0), "ballistic", None)
        >>> region = prediction.region(0.5)
        >>> round(region.major, 3), round(region.minor, 3), region.angle
        (23.548, 11.774, 0.0)
        """
        level = probability(level)
        if self.scale is None:
            return None
        return region_of(level, self.x, self.y, *self.scale, NORMAL if self.tail is None else self.tail)


class Place(NamedTuple):
    """Where movements of this person ended before: ``x y`` px, as the destination of the present movement.

    ``p``: how likely it is now, ``before``: how likely it was before the movement showed anything; both
    beside the other places and beside everywhere else, so that they sum to less than 1. ``visits``: how many
    movements ended there, earlier ones counting less; at most 33.4. ``id``: from 0 to 63, the same as long as
    the place is remembered, also in a saved person; a place that replaces a forgotten one takes its id.
    ``spread`` px: the standard deviation of visits around the place, as this person's scatter grows with the
    distance from where the movement starts.
    """

    x: float
    y: float
    p: float
    before: float
    visits: float
    id: int
    spread: float


Pair = tuple[PointerEvent, Prediction | None]
"""An event and what is predicted at it; ``None`` where nothing is justified."""


EVENT_FIELDS = fields_of(PointerEvent)
MOTION_FIELDS = fields_of(Motion)


class EventRow(NamedTuple):
    """A ``PointerEvent`` as laws name its floats: counts NaN where there are none."""

    t: float
    x: float
    y: float
    dx: float
    dy: float
    buttons: float


class MotionRow(NamedTuple):
    """A ``Motion`` as laws name its floats; the last three are 0 or 1."""

    t: float
    x: float
    y: float
    vx: float
    vy: float
    ax: float
    ay: float
    settled: float
    start: float
    counts: float


class PredictionRow(NamedTuple):
    """A ``Prediction`` as laws name its floats; ``phase`` is its place in ``PHASES``.

    ``x`` is NaN where nothing is justified, ``t`` where the row was refused: see ``refused``.
    """

    t: float
    x: float
    y: float
    sxx: float
    sxy: float
    syy: float
    remaining_s: float
    phase: float
    tail: float
    remaining_spread: float


PREDICTION_FIELDS = tuple(
    sorted(fields_of(Prediction), key=lambda field: PredictionRow._fields.index(field.name))
)
"""In the order of rows, files and packed records: what a version of the wire adds comes last."""

Row = tuple[float, ...]
"""A row as laws hand it on: building a named one for Python would cost a law a microsecond."""
SixFloats = tuple[float, float, float, float, float, float]
TenFloats = tuple[float, float, float, float, float, float, float, float, float, float]

# Why a law refuses a row: its time lies before the last; or this plus the place of the field that is wrong,
# of an event or of a motion.
FINE, ORDER, EVENT_FIELD = 0, 1, 2
MOTION_FIELD = EVENT_FIELD + len(EVENT_FIELDS)


@law
def refused(code: int, value: float) -> TenFloats:
    """The answer of a law to a row that it refuses: NaN for a time, why, and what it was compared with.

    ``value``: the time of the row before, or the value of the field that is wrong. The law's memory is then
    unchanged. ``refusal`` makes the sentence.
    """
    return nan, float(code), value, nan, nan, nan, nan, nan, nan, nan


@law
def fault_of_event(event: EventRow) -> int:
    """Whether the values make an event: all within their bounds, buttons whole, counts both or none (NaN).

    FINE, or EVENT_FIELD plus the place of the first that does not.
    """
    t, x, y, dx, dy, buttons = event
    if not abs(t) <= LATEST_S:
        return EVENT_FIELD
    if not abs(x) <= LARGEST:
        return EVENT_FIELD + 1
    if not abs(y) <= LARGEST:
        return EVENT_FIELD + 2
    if not (dx != dx and dy != dy):
        if not abs(dx) <= LARGEST:
            return EVENT_FIELD + 3
        if not abs(dy) <= LARGEST:
            return EVENT_FIELD + 4
    if not (0.0 <= buttons <= LARGEST and buttons == floor(buttons)):
        return EVENT_FIELD + 5
    return FINE


@law
def event_at(table: FloatTable, i: int) -> SixFloats:
    """A row of a table of events as a tuple."""
    r = table[i]
    return r[0], r[1], r[2], r[3], r[4], r[5]


@law
def row_at(table: FloatTable, i: int) -> TenFloats:
    """A row of a table of motions or of predictions as a tuple."""
    r = table[i]
    return r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8], r[9]


@law
def endpoint(t: float, x: float, y: float, phase: float) -> TenFloats:
    """The row of a prediction that claims an endpoint and nothing else; ``x`` is NaN where it claims none."""
    return t, x, y, nan, nan, nan, nan, phase, nan, nan


def event_row(event: PointerEvent) -> SixFloats:
    """The row of an event; raises EventError where a field is no number. Bounds are the law's to check."""
    try:
        t, x, y, dx, dy, buttons = event.t, event.x, event.y, event.dx, event.dy, event.buttons
        if float is type(t) is type(x) is type(y) and int is type(buttons):  # most events, in half the time
            if dx is None is dy:
                return t, x, y, nan, nan, float(buttons)
            if float is type(dx) is type(dy) and dx == dx and dy == dy:
                return t, x, y, dx, dy, float(buttons)
        counts = [count for count in (dx, dy) if count is not None]
        if all(map(is_number, (t, x, y, *counts, buttons))) and dx == dx and dy == dy:
            dx, dy = nan if dx is None else float(dx), nan if dy is None else float(dy)
            return float(t), float(x), float(y), dx, dy, float(buttons)
    except OverflowError:
        pass
    except AttributeError as missing:
        raise EventError(f"an event must be a PointerEvent, received {event!r:.80}") from missing
    field = next(one for one in EVENT_FIELDS if one.fault(getattr(event, one.name)))
    value = getattr(event, field.name)
    raise EventError(field.fault(value), field=field.name, value=value)


def refusal(row: Sequence[float], answer: Sequence[float], where: str = "") -> EventError:
    """The error for an event or a motion that a law refused with this answer; see ``refused``."""
    code, value, t = int(answer[1]), answer[2], row[0]
    if code == ORDER:
        words = f"{where}t must not run backwards: received {t!r} s after {value!r} s"
        return EventOrderError(words, field="t", value=t)
    if code >= MOTION_FIELD:
        field = MOTION_FIELDS[code - MOTION_FIELD]
    else:
        field, value = EVENT_FIELDS[code - EVENT_FIELD], row[code - EVENT_FIELD]
        if field.optional and value != value:
            dx, dy = (None if count != count else count for count in row[3:5])
            words = f"{where}dx and dy come together or not at all, received {dx!r} and {dy!r}"
            return EventError(words, field="dx", value=dx)
    return EventError(f"{where}{field.fault(value)}", field=field.name, value=value)


def event_of(row: Row) -> PointerEvent:
    """The event of a row."""
    t, x, y, dx, dy, buttons = row
    return PointerEvent(t, x, y, dx if dx == dx else None, dy if dy == dy else None, int(buttons))


def motion_row(motion: Motion) -> TenFloats:
    """The row of a motion."""
    speeds = float(motion.vx), float(motion.vy), float(motion.ax), float(motion.ay)
    marks = float(motion.settled), float(motion.start), float(motion.counts)
    return float(motion.t), float(motion.x), float(motion.y), *speeds, *marks


def motion_of(row: Row) -> Motion:
    """The motion of a row."""
    t, x, y, vx, vy, ax, ay, settled, start, counts = row
    return Motion(t, x, y, vx, vy, ax, ay, bool(settled), bool(start), bool(counts))


def prediction_row(prediction: Prediction | None, t: float = nan) -> TenFloats:
    """The row of a prediction; of ``None``, at ``t`` s, one that holds nothing else."""
    if prediction is None:
        return t, nan, nan, nan, nan, nan, nan, nan, nan, nan
    place = float(prediction.t), float(prediction.x), float(prediction.y)
    sxx, sxy, syy = (nan, nan, nan) if prediction.scale is None else map(float, prediction.scale)
    left = nan if prediction.remaining_s is None else float(prediction.remaining_s)
    tail = nan if prediction.tail is None else float(prediction.tail)
    spread = nan if prediction.remaining_spread is None else float(prediction.remaining_spread)
    return *place, sxx, sxy, syy, left, float(PHASES.index(prediction.phase)), tail, spread


def prediction_of(row: Row) -> Prediction | None:
    """The prediction of a row; ``None`` where it claims no endpoint."""
    t, x, y, sxx, sxy, syy, remaining_s, phase, tail, spread = row
    if x != x:
        return None
    scale = (sxx, sxy, syy) if sxx == sxx else None
    left = remaining_s if remaining_s == remaining_s else None
    freedom = tail if tail == tail else None
    return Prediction(t, x, y, scale, PHASES[int(phase)], left, freedom, spread if spread == spread else None)


class EventColumns(Columns[PointerEvent]):
    """Pointer events as columns, with ``begin`` marking the rows before which a stage is reset."""

    names = EventRow._fields
    titles = tuple(field.column for field in EVENT_FIELDS)

    def __init__(self, table: ArrayLike, begin: BoolArray | None = None) -> None:
        super().__init__(table)
        count = len(self.table)
        self.begin = np.zeros(count, np.bool_) if begin is None else np.ascontiguousarray(begin, np.bool_)
        if self.begin.shape != (count,):
            raise EventError(f"begin needs {count} rows, received shape {self.begin.shape}")

    @classmethod
    def of(
        cls,
        t: ArrayLike,
        x: ArrayLike,
        y: ArrayLike,
        dx: ArrayLike | None = None,
        dy: ArrayLike | None = None,
        buttons: ArrayLike | None = None,
        begin: BoolArray | None = None,
    ) -> Self:
        """Columns from one array a field, all of the same length; what is missing is ``None`` or 0.

        Warns of t in milliseconds. Raises EventError for an array of another length or of no numbers.
        """
        time = numbers_of(t, "t")
        if time.ndim != 1:
            raise EventError(f"t needs one number a row, received shape {time.shape}")
        table = np.column_stack([np.full((len(time), 5), np.nan), np.zeros(len(time))])
        for column, values in enumerate((time, x, y, dx, dy, buttons)):
            if values is None:
                continue
            numbers = numbers_of(values, cls.names[column])
            if numbers.shape != time.shape:
                raise EventError(
                    f"{cls.names[column]} needs {len(time)} rows as t has, received shape {numbers.shape}"
                )
            table[:, column] = numbers
        warn_of_milliseconds(np.diff(time))
        return cls(table, begin)

    @classmethod
    def of_frame(cls, frame: pd.DataFrame) -> Self:
        """Columns from a ``pandas.DataFrame`` with ``t, x, y`` or ``t_s, x_px, y_px``.

        ``dx, dy`` or ``dx_counts, dy_counts``, ``buttons`` and ``begin`` may be there; others are left aside.
        """
        names = {**dict(zip(cls.names, cls.titles, strict=True)), "begin": "begin"}
        return cls.of(**columns_of_frame(frame, names, 3))

    @classmethod
    def of_events(cls, events: Iterable[PointerEvent]) -> Self:
        """Columns from records."""
        return cls(np.array([event_row(event) for event in events], dtype=np.float64).reshape(-1, 6))

    def events(self) -> Iterator[PointerEvent]:
        """The rows as records."""
        return iter(self)

    def rows(self, start: int, stop: int) -> Self:
        """The rows from ``start`` up to ``stop``."""
        return self[start:stop]

    def to_pandas(self) -> pd.DataFrame:
        """As of all columns, with ``begin``."""
        return super().to_pandas().assign(buttons=self.buttons.astype(np.int64), begin=self.begin)

    def _record(self, row: list[float]) -> PointerEvent:
        return event_of(tuple(row))

    def _rows(self, some: slice) -> Self:
        return type(self)(self.table[some], self.begin[some])

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.table, self.begin)


class MotionColumns(Columns[Motion]):
    """Motions as columns."""

    names = MotionRow._fields

    def motions(self) -> Iterator[Motion]:
        """The rows as records."""
        return iter(self)

    def _record(self, row: list[float]) -> Motion:
        return motion_of(tuple(row))


class RegionColumns(Columns[Region | None]):
    """Regions as columns, in the units of ``Region``; a row without a region is NaN."""

    names = ("x", "y", "major", "minor", "angle")

    def _record(self, row: list[float]) -> Region | None:
        return Region(*row) if row[0] == row[0] else None


class PredictionColumns(Columns[Prediction | None]):
    """Predictions as columns; a row without a prediction is NaN but for ``t`` and the phase."""

    names = PredictionRow._fields
    titles = tuple(field.column for field in PREDICTION_FIELDS)

    def predictions(self) -> Iterator[Prediction | None]:
        """The rows as records, ``None`` where nothing was justified."""
        return iter(self)

    def region(self, level: float) -> RegionColumns:
        """``Prediction.region`` of each row; raises ParameterError for a level outside (0, 1)."""
        level = probability(level)
        claimed = self.table[:, [1, 2, 3, 4, 5, 8]].tolist()
        regions = [region_of(level, *row) for row in claimed]
        none = (np.nan,) * len(RegionColumns.names)
        rows = [none if one is None else (one.x, one.y, one.major, one.minor, one.angle) for one in regions]
        return RegionColumns(np.array(rows, dtype=np.float64).reshape(-1, len(RegionColumns.names)))

    def to_pandas(self) -> pd.DataFrame:
        """As of all columns, with the phase as a word."""
        phases: list[str | None] = [
            PHASES[int(code)] if code == code else None for code in self.phase.tolist()
        ]
        return super().to_pandas().assign(phase=np.array(phases, dtype=object))

    def _record(self, row: list[float]) -> Prediction | None:
        return prediction_of(tuple(row))
