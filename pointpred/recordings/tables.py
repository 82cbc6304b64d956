"""Any table as samples: its columns mapped to ours, in our units, a row a sample."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow.compute as pc

from pointpred.errors import ColumnsError
from pointpred.recording import Provenance, Recording
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import ColumnTable, IntArray, as_arrow
from pointpred.recordings.columns import clocks
from pointpred.recordings.columns.buttons import buttons_of, held, names_only, tells_release
from pointpred.recordings.columns.clocks import (
    HEAD,
    clock_notes,
    counts_frames,
    is_numbers,
    only_whole_seconds,
    units_of,
)
from pointpred.recordings.columns.expansion import expand
from pointpred.recordings.columns.list_cells import SERIES, Opened, holds_lists, open_lists
from pointpred.recordings.columns.mapping import command_for, mapping, unit_refusal
from pointpred.recordings.columns.names import similar_names
from pointpred.recordings.encodings import stem_of
from pointpred.recordings.reading import KEYS, NEEDED, Reading
from pointpred.recordings.samples import Samples, recording_of
from pointpred.recordings.trials import LATE_S, TARGET, Codes, codes_of
from pointpred.records import EVENT_FIELDS, BoolArray, EventColumns, FloatArray

MOSTLY = 0.5
"""Largest share of cells that are not numbers in a column of numbers."""
OFTEN, FEW = 0.2, 3
"""With a larger share and number of backward steps a column is not a clock that restarts."""


def recording_of_table(path: Path, table: ColumnTable, reading: Reading) -> Recording:
    """The recording in a table, by what its format says, ``reading.columns`` or the usual names of columns.

    Notes list the assumptions. Raises ColumnsError, which names the columns and a mapping to try, if no
    mapping is certain, and RecordingError if a mapped column has the wrong content.
    """
    if table.known is None:
        table = expand(path, table, reading)
    recording = recording_of(_MappedTable(path, table, reading).samples(), reading)
    if table.known is not None:
        return recording
    position_notes = _position_notes(recording.events, reading)
    return msgspec.structs.replace(recording, notes=(*recording.notes, *position_notes))


def _position_notes(events: EventColumns, reading: Reading) -> list[str]:
    """Notes if positions without a stated unit are unlikely to be px with y downwards."""
    if not len(events):
        return []
    notes = []
    if reading.px_per_unit is None and max(np.ptp(events.x), np.ptp(events.y)) <= 1.0:
        notes.append(
            "all positions lie within 1 px: are they shares of the screen, or metres? --px-per-unit converts"
        )
    if not reading.y_up and events.y.max() <= 0.0 and events.y.min() < 0.0 <= events.x.min():
        notes.append("y is never above 0: does it grow upwards? --y-up turns it")
    return notes


class _MappedTable:
    """A table whose columns are mapped to our fields: ``mapping`` field -> column; raises ColumnsError."""

    def __init__(self, path: Path, table: ColumnTable, reading: Reading) -> None:
        self.path, self.table, self.reading, self.known = path, table, reading, table.known
        self.names = list(table.columns)
        self.notes = list(table.notes)
        self._arrays: dict[str, Any] = {}
        across, down = reading.gain
        if table.known is not None:
            self.mapping, (across, down) = dict(table.known.fields), table.known.gain
        else:
            self.mapping, notes = mapping(path, self.names, reading, self._same, self.column)
            self.notes += notes
            down = -down if reading.y_up else down
        self._check_sure()
        self.gains = {
            "x": across,
            "y": down,
            "target_x": across,
            "target_y": down,
            "target_w": across,
        }
        self.one_user = (table.known and table.known.one_user) or stem_of(path)
        self.opened: Opened | None = None

    def column(self, name: str) -> Any:
        """A column as an Arrow array."""
        if name not in self._arrays:
            self._arrays[name] = as_arrow(self.table.columns[name])
        return self._arrays[name]

    def field(self, field: str) -> Any:
        """The column of a field as an Arrow array, a row a sample where its cells were lists."""
        if self.opened is not None and field in SERIES:
            return self.opened.series[field]
        return self.column(self.mapping[field])

    @property
    def others(self) -> list[str]:
        """The columns not mapped to a field."""
        return [name for name in self.names if name not in self.mapping.values()]

    @property
    def count(self) -> int:
        """Rows."""
        return len(self.column(self.mapping["t"]))

    def samples(self) -> Samples:
        """The samples, in seconds, px and counts; raises ColumnsError."""
        row_of = np.arange(self.count, dtype=np.int64)
        if self.table.row_of is not None:
            row_of = np.asarray(self.table.row_of, dtype=np.int64)
        if any(holds_lists(self.field(field)) for field in NEEDED):
            self._open(row_of)
        unit, how = self._unit()
        times, wrong = clocks.clock(self.field("t"), unit == "iso")
        opened, known = self.opened, self.known
        cells = None if opened is None else opened.rows
        samples = Samples(
            name=stem_of(self.path),
            table=np.full((len(times), len(EVENT_FIELDS)), np.nan),
            row_of=row_of if cells is None else row_of[cells],
            provenance=self._provenance(how),
            one_user=self.one_user,
            per_second=clocks.PER_SECOND[unit],
            cut=None if known is None else known.cut,
            columns={name: self.column(name) for name in self.others if not holds_lists(self.column(name))},
            cells=cells,
            targets=np.full((len(times), len(TARGET)), np.nan),
            faults={} if known is None else dict(known.faults),
            skipped=[*self.table.skipped, *(opened.skipped if opened else [])],
        )
        samples.table[:, 0], samples.table[:, -1] = times, 0.0
        self._blame(samples, "t", wrong, "a date and time" if unit == "iso" else "a number")
        self._read_numbers(samples)
        samples.user, samples.trial = self._codes("user"), self._codes("trial")
        self._read_buttons(samples)
        self._check_steps(samples)
        if self.known is None:
            fields = (f"{field} = {name}" + how * (field == "t") for field, name in self.mapping.items())
            self.notes.insert(len(self.table.notes), "columns: " + ", ".join(fields))
        if "user" not in self.mapping and (known is None or known.one_user is None):
            self.notes.append(f"one user, {self.one_user!r}: no column for users")
        unread = [name for name in self.others if name not in samples.columns]
        samples.notes = [*self.notes, *(opened.notes if opened else [])]
        if unread:
            samples.notes.append(f"columns left aside, for they hold lists: {', '.join(unread)}")
        return samples

    def _open(self, row_of: IntArray) -> None:
        """Make a row a sample of rows that are trials."""
        lacking = [self.mapping[field] for field in NEEDED if not holds_lists(self.field(field))]
        if lacking and self.known is None:
            raise self._refusal(f"t, x and y must be lists alike; {', '.join(lacking)} holds none")
        fields = {field: self.field(field) for field in (*SERIES, *KEYS) if field in self.mapping}
        self.opened = open_lists(fields, row_of, self.one_user)
        if "trial" not in self.mapping and self.known is None:
            self.notes.append("a trial a row, named after it: no column for trials")

    def _codes(self, key: str) -> Codes | None:
        """The user or the trial of each sample."""
        if self.opened is not None:
            return self.opened.user if key == "user" else self.opened.trial
        if key not in self.mapping:
            return None
        codes, names = codes_of(pc.utf8_trim_whitespace(arrow_tables.words(self.field(key))).fill_null(""))
        numbers, words = arrow_tables.numbers(as_arrow(names))
        if not words and np.isfinite(numbers).any():  # among numbers, NaN and NA are empty cells
            names = ["" if number != number else name for name, number in zip(names, numbers, strict=True)]
        return codes, names

    def _unit(self) -> tuple[str, str]:
        """The unit of time, and its source for notes; raises ColumnsError if it is unknown."""
        if self.known is not None:
            return self.known.time_unit, ""
        column = self.field("t")
        units, how = units_of(self.mapping["t"], column, self.reading.time_unit)
        if not units and not is_numbers(column):
            cell = next((str(cell) for cell in column.slice(0, HEAD).to_pylist() if cell is not None), "")
            raise self._refusal(
                f"the cells of the column {self.mapping['t']!r} (t) are neither numbers nor dates and times",
                f", such as {arrow_tables.short(cell)!r}; dates are written 2024-03-01T10:00:00.123",
            )
        if len(units) != 1:
            frames = counts_frames(column)
            raise unit_refusal(self.path, self.names, self.mapping, units, self.reading, frames)
        return units[0], how

    def _refusal(self, reason: str, more: str = "") -> ColumnsError:
        """The error for cells that do not match the mapping; ``more`` is not part of its reason."""
        return ColumnsError(f"{self.path}: {reason}{more}", self.names, self.mapping, reason=reason)

    def _provenance(self, how: str) -> Provenance:
        """The provenance, from the format, or from the table and ``reading``."""
        reading = self.reading
        if self.known is not None:
            return msgspec.structs.replace(self.known.provenance, dpi=reading.dpi, cpi=reading.cpi)
        px = " and ".join(f"{gain:g}" for gain in dict.fromkeys(reading.gain))
        return Provenance(
            self.table.format,
            unit="px" if reading.px_per_unit is None else f"units of {px} px",
            origin="as in the file",
            y_axis="up" if reading.y_up else "down",
            clock=f"column {self.mapping['t']}{how}",
            dpi=reading.dpi,
            cpi=reading.cpi,
        )

    def _check_sure(self) -> None:
        """Raise ColumnsError if a column of numbers is ambiguous."""
        for field in (*NEEDED, *TARGET):
            if why := self.table.unsure.get(self.mapping.get(field, "")):
                more = "; write numbers with a decimal point and without thousands separators"
                raise self._refusal(f"the column {self.mapping[field]!r} ({field}): {why}", more)

    def _same(self, some: Sequence[str]) -> bool:
        """Whether columns group the rows equally."""
        return all(_part_alike(self.column(some[0]), self.column(other)) for other in some[1:])

    def _blame(self, samples: Samples, field: str, wrong: dict[int, str], expected: str) -> None:
        """Add the cells of a column that cannot be read."""
        name = self.mapping[field]
        called = field if field == name else f"{field} ({name})"
        for row, cell in wrong.items():
            samples.faults.setdefault(row, f"{called} is {cell!r}, expected {expected}")

    def _read_numbers(self, samples: Samples) -> None:
        """Positions, counts and targets in px; raises ColumnsError if most positions are not numbers."""
        assert samples.targets is not None
        for place, field in enumerate(("t", "x", "y", "dx", "dy")):
            if field in self.mapping and field != "t":
                numbers, wrong = arrow_tables.finite_numbers(self.field(field))
                with np.errstate(over="ignore"):  # overflow is handled with its row
                    samples.table[:, place] = numbers * self.gains.get(field, 1.0) + 0.0  # no negative zero
                self._blame(samples, field, wrong, "a number")
            if field in NEEDED:
                self._check_numbers(field, samples.table[:, place])
        for place, field in enumerate(TARGET):
            if field in self.mapping:
                numbers, wrong = arrow_tables.finite_numbers(self.field(field))
                if wrong:
                    at, cell = min(wrong.items())
                    row = at if self.table.row_of is None else self.table.row_of[at]
                    self.notes.append(
                        f"cells of {self.mapping[field]} that are no numbers: {len(wrong)}, "
                        f"the first is {cell!r} in data row {row}"
                    )
                with np.errstate(over="ignore"):
                    numbers = numbers * self.gains[field] + 0.0
                samples.targets[:, place] = numbers if samples.cells is None else numbers[samples.cells]

    def _read_buttons(self, samples: Samples) -> None:
        """Add the buttons; a column of that name without buttons is ignored."""
        if "buttons" not in self.mapping:
            return
        name, column = self.mapping["buttons"], self.field("buttons")
        explicit = "buttons" in (self.reading.columns or {})
        others = []
        if not explicit and self.known is None and names_only(column):
            others = [other for other in self.others if tells_release(self.column(other))]
        placed: BoolArray = np.logical_and.reduce(np.isfinite(samples.table[:, :3]), axis=1)
        pressed = None if others else buttons_of(self.path, name, column, explicit, placed)
        if pressed is not None:
            user = samples.users[0]
            trial = user if samples.trial is None else samples.trial[0]
            late_s = np.inf if self.reading.sort else LATE_S
            times = samples.table[:, 0] / samples.per_second
            samples.table[:, -1] = held(column, pressed, user, trial, times, late_s)
            return
        either = " or ".join((name, *others))
        self.notes.append(
            f"buttons is not read: {either} may be meant; name one with --columns buttons=..."
            if others
            else f"column {name} is left aside: its cells are not buttons"
        )
        del self.mapping["buttons"]
        if not holds_lists(self.column(name)):
            samples.columns[name] = self.column(name)

    def _check_numbers(self, field: str, values: FloatArray) -> None:
        """Raise ColumnsError if most cells of a column are not numbers."""
        bad = np.flatnonzero(~np.isfinite(values))
        if len(bad) <= MOSTLY * len(values) or self.known is not None:
            return
        row = int(bad[0])
        cell = arrow_tables.short(str(self.field(field)[row].as_py()))
        kind = "number or possible date" if field == "t" else "number"
        count = f"{len(bad)} of {len(values)} cells"
        raise self._refusal(
            f"{count} of the column {self.mapping[field]!r} ({field}) are no {kind}",
            f", such as {cell!r} in data row {row}: is it another column, or another unit of time?",
        )

    def _check_steps(self, samples: Samples) -> None:
        """Note implausible steps of the clock; raise ColumnsError if it is too coarse to cut a stream."""
        times, name = samples.table[:, 0], self.mapping["t"]
        if self.known is not None:
            return
        if samples.trial is None and not self.reading.sort:
            self._check_clock(times, samples.user)
        self.notes += clock_notes(name, samples.per_second, times, samples.user)
        if only_whole_seconds(times, samples.per_second, samples.user):
            reason = f"the time (column {name!r}) has only whole seconds, with several rows in each"
            if samples.trial is None:
                raise self._refusal(reason, ": too coarse to cut; is there another column of times?")
            self.notes.append(f"{reason}: a movement within one takes no time")

    def _check_clock(self, clock: FloatArray, users: Codes | None) -> None:
        """Raise ColumnsError if the time of a stream decreases so often that it must be intervals."""
        if users is not None:
            clock = clock[np.argsort(users[0], kind="stable")]
        steps = np.diff(clock[np.isfinite(clock)])
        back = int(np.count_nonzero(steps < 0))
        if back > max(OFTEN * len(steps), FEW):
            rest = {field: name for field, name in self.mapping.items() if field != "t"}
            likely = similar_names(self.others).get("t", "COLUMN")
            raise ColumnsError(
                f"{self.path}: the time (column {self.mapping['t']!r}) goes backwards in {back} of "
                f"{len(steps)} steps: does it hold intervals? try: "
                f"{command_for(self.path, rest | {'t': likely})}; where it is the time "
                "of each trial, name the column of the trials: --columns trial=...",
                self.names,
                rest,
            )


def _part_alike(one: Any, other: Any) -> bool:
    """Whether two columns group the rows equally."""
    codes: list[IntArray] = [
        codes_of(pc.fill_null(arrow_tables.words(column), ""))[0] for column in (one, other)
    ]
    together = len(np.unique(codes[0] * (codes[1].max(initial=0) + 1) + codes[1]))
    return together == len(np.unique(codes[0])) == len(np.unique(codes[1]))
