"""Any table of samples as a recording: its columns mapped to ours, converted, grouped or cut into trials."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow.compute as pc

from pointpred.errors import ColumnsError
from pointpred.recording import Provenance, Recording
from pointpred.recordings import arrow_tables
from pointpred.recordings.arrow_tables import ColumnTable
from pointpred.recordings.columns import clocks
from pointpred.recordings.columns.buttons import buttons_of
from pointpred.recordings.columns.clocks import (
    HEAD,
    clock_notes,
    counts_frames,
    is_numbers,
    only_whole_seconds,
    units_of,
)
from pointpred.recordings.columns.expansion import as_arrow, expand
from pointpred.recordings.columns.list_rows import holds_lists, recording_of_lists, steps_of
from pointpred.recordings.columns.mapping import command_for, mapping, unit_refusal
from pointpred.recordings.columns.names import similar_names
from pointpred.recordings.columns.sample_rows import Rows, recording_of_rows
from pointpred.recordings.reading import KEYS, NEEDED, Reading
from pointpred.recordings.trials import TARGET, codes_of
from pointpred.records import EventColumns, FloatArray

MOSTLY = 0.5
"""Largest share of cells that are not numbers in a column of numbers."""
OFTEN, FEW = 0.2, 3
"""With a larger share and number of backward steps a column is not a clock that restarts."""


def recording_of_table(path: Path, table: ColumnTable, reading: Reading) -> Recording:
    """The recording in a table, by ``reading.columns`` or the usual names of columns.

    Notes list the assumptions. Raises ColumnsError, which names the columns and a mapping to try, if no
    mapping is certain, and RecordingError if a mapped column has the wrong content.
    """
    mapped = _MappedTable(path, expand(path, table, reading), reading)
    recording = _of_lists(mapped) if mapped.holds_lists else _of_rows(mapped)
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
        self.path, self.table, self.reading = path, table, reading
        self.names = list(table.columns)
        self._arrays: dict[str, Any] = {}
        self.mapping, self.notes = mapping(path, self.names, reading, self._same, self.column)
        self._check_sure()
        across, down = reading.gain
        down = -down if reading.y_up else down
        self.gains = {"x": across, "y": down, "target_x": across, "target_y": down, "target_w": across}

    def column(self, name: str) -> Any:
        """A column as an Arrow array."""
        if name not in self._arrays:
            self._arrays[name] = as_arrow(self.table.columns[name])
        return self._arrays[name]

    def field(self, field: str) -> Any:
        """The column of a field as an Arrow array."""
        return self.column(self.mapping[field])

    @property
    def count(self) -> int:
        """Rows."""
        return len(self.field("t"))

    @property
    def others(self) -> list[str]:
        """The columns not mapped to a field."""
        return [name for name in self.names if name not in self.mapping.values()]

    @property
    def holds_lists(self) -> bool:
        """Whether a row is a trial."""
        return any(holds_lists(self.field(field)) for field in NEEDED)

    def unit(self) -> tuple[str, str]:
        """The unit of time, and its source for notes; raises ColumnsError if it is unknown."""
        column = self.field("t")
        units, how = units_of(self.mapping["t"], column, self.reading.time_unit)
        if not units and not is_numbers(column) and not holds_lists(column):
            cell = next((str(cell) for cell in column.slice(0, HEAD).to_pylist() if cell is not None), "")
            reason = (
                f"the cells of the column {self.mapping['t']!r} (t) are neither numbers nor dates and times"
            )
            raise self.refusal(
                reason, f", such as {arrow_tables.short(cell)!r}; dates are written 2024-03-01T10:00:00.123"
            )
        if len(units) != 1:
            frames = counts_frames(column)
            raise unit_refusal(self.path, self.names, self.mapping, units, self.reading, frames)
        return units[0], how

    def refusal(self, reason: str, more: str = "") -> ColumnsError:
        """The error for cells that do not match the mapping; ``more`` is not part of its reason."""
        return ColumnsError(f"{self.path}: {reason}{more}", self.names, self.mapping, reason=reason)

    def provenance(self, how: str) -> Provenance:
        """The provenance, from the table and ``reading``."""
        reading = self.reading
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

    def all_notes(self, how: str) -> tuple[str, ...]:
        """The notes of the table, the mapping, and the assumptions."""
        pairs = (f"{field} = {name}" + (how if field == "t" else "") for field, name in self.mapping.items())
        return (*self.table.notes, "columns: " + ", ".join(pairs), *self.notes)

    def _check_sure(self) -> None:
        """Raise ColumnsError if a column of numbers is ambiguous."""
        for field in (*NEEDED, *TARGET):
            if why := self.table.unsure.get(self.mapping.get(field, "")):
                more = "; write numbers with a decimal point and without thousands separators"
                raise self.refusal(f"the column {self.mapping[field]!r} ({field}): {why}", more)

    def _same(self, some: Sequence[str]) -> bool:
        """Whether columns group the rows equally."""
        return all(_part_alike(self.column(some[0]), self.column(other)) for other in some[1:])


def _of_lists(mapped: _MappedTable) -> Recording:
    """The recording in a table with one trial per row; raises ColumnsError."""
    lacking = [mapped.mapping[field] for field in NEEDED if not holds_lists(mapped.field(field))]
    if lacking:
        raise mapped.refusal(f"t, x and y must be lists alike; {', '.join(lacking)} holds none")
    if mapped.reading.cut is not None:
        mapped.notes.append(f"cut {mapped.reading.cut!r} has no effect: a row of the table is a trial")
    unit, how = mapped.unit()
    mapped.notes += clock_notes(mapped.mapping["t"], clocks.PER_SECOND[unit], steps_of(mapped.field("t")))
    return recording_of_lists(
        mapped.path,
        mapped.column,
        mapped.mapping,
        mapped.others,
        per_second=clocks.PER_SECOND[unit],
        gain=(mapped.gains["x"], mapped.gains["y"]),
        provenance=mapped.provenance(how),
        skipped=mapped.table.skipped,
        notes=mapped.all_notes(how),
        sort=mapped.reading.sort,
    )


def _of_rows(mapped: _MappedTable) -> Recording:
    """The recording in a table with one sample per row; raises ColumnsError."""
    row_of = mapped.table.row_of
    rows = Rows(mapped.count, np.arange(mapped.count, dtype=np.int64) if row_of is None else row_of)
    unit, how = mapped.unit()
    rows.values["t"], wrong = clocks.clock(mapped.field("t"), unit == "iso")
    rows.blame("t", mapped.mapping["t"], wrong, "a date and time" if unit == "iso" else "a number")
    rows.per_second = clocks.PER_SECOND[unit]
    _read_numbers(mapped, rows)
    _read_buttons(mapped, rows)
    keys = {
        key: pc.utf8_trim_whitespace(arrow_tables.words(mapped.field(key)))
        for key in KEYS
        if key in mapped.mapping
    }
    _check_steps(mapped, rows, keys)
    return recording_of_rows(
        mapped.path,
        rows,
        keys,
        {name: mapped.column(name) for name in mapped.others},
        mapped.reading,
        provenance=mapped.provenance(how),
        skipped=mapped.table.skipped,
        notes=mapped.all_notes(how),
    )


def _read_numbers(mapped: _MappedTable, rows: Rows) -> None:
    """Add positions, counts and targets in px to ``rows``; raises ColumnsError if most are not numbers."""
    for field in ("x", "y", "dx", "dy", *TARGET):
        if field in mapped.mapping:
            numbers, wrong = arrow_tables.finite_numbers(mapped.field(field))
            with np.errstate(over="ignore"):  # overflow is handled with its row
                rows.values[field] = numbers * mapped.gains.get(field, 1.0) + 0.0  # no negative zero
            if field not in TARGET:
                rows.blame(field, mapped.mapping[field], wrong, "a number")
    for field in NEEDED:
        _check_numbers(mapped, field, rows.values[field])


def _read_buttons(mapped: _MappedTable, rows: Rows) -> None:
    """Add the buttons to ``rows``; a column of that name without buttons is ignored."""
    if "buttons" not in mapped.mapping:
        return
    name = mapped.mapping["buttons"]
    explicit = "buttons" in (mapped.reading.columns or {})
    pressed = buttons_of(mapped.path, name, mapped.field("buttons"), explicit)
    if pressed is None:
        mapped.notes.append(f"column {name} is left aside: its cells are not buttons")
        del mapped.mapping["buttons"]
    else:
        rows.values["buttons"] = pressed


def _check_numbers(mapped: _MappedTable, field: str, values: FloatArray) -> None:
    """Raise ColumnsError if most cells of a column are not numbers."""
    bad = np.flatnonzero(~np.isfinite(values))
    if len(bad) <= MOSTLY * len(values):
        return
    row = int(bad[0])
    cell = arrow_tables.short(str(mapped.field(field)[row].as_py()))
    kind = "number or possible date" if field == "t" else "number"
    raise mapped.refusal(
        f"{len(bad)} of {len(values)} cells of the column {mapped.mapping[field]!r} ({field}) are no {kind}",
        f", such as {cell!r} in data row {row}: is it another column, or another unit of time?",
    )


def _check_steps(mapped: _MappedTable, rows: Rows, keys: Mapping[str, Any]) -> None:
    """Note implausible steps of the clock; raise ColumnsError if it is too coarse to cut a stream."""
    times, users = rows.values["t"], keys.get("user")
    if "trial" not in keys and not mapped.reading.sort:
        _check_clock(mapped, times, users)
    mapped.notes += clock_notes(mapped.mapping["t"], rows.per_second, times, users)
    if only_whole_seconds(times, rows.per_second, users):
        reason = (
            f"the time (column {mapped.mapping['t']!r}) has only whole seconds, with several rows in each"
        )
        if "trial" not in keys:
            raise mapped.refusal(reason, ": too coarse to cut; is there another column of times?")
        mapped.notes.append(f"{reason}: a movement within one takes no time")


def _check_clock(mapped: _MappedTable, clock: FloatArray, users: Any) -> None:
    """Raise ColumnsError if the time of a stream decreases so often that it must be intervals."""
    if users is not None:
        clock = clock[np.argsort(codes_of(pc.fill_null(users, ""))[0], kind="stable")]
    steps = np.diff(clock[np.isfinite(clock)])
    back = int(np.count_nonzero(steps < 0))
    if back > max(OFTEN * len(steps), FEW):
        rest = {field: name for field, name in mapped.mapping.items() if field != "t"}
        likely = similar_names(mapped.others).get("t", "COLUMN")
        raise ColumnsError(
            f"{mapped.path}: the time (column {mapped.mapping['t']!r}) goes backwards in {back} of "
            f"{len(steps)} steps: does it hold intervals? try: "
            f"{command_for(mapped.path, rest | {'t': likely})}; where it is the time "
            "of each trial, name the column of the trials: --columns trial=...",
            mapped.names,
            rest,
        )


def _part_alike(one: Any, other: Any) -> bool:
    """Whether two columns group the rows equally."""
    codes = [codes_of(pc.fill_null(arrow_tables.words(column), ""))[0] for column in (one, other)]
    together = len(np.unique(codes[0] * (codes[1].max(initial=0) + 1) + codes[1]))
    return together == len(np.unique(codes[0])) == len(np.unique(codes[1]))
