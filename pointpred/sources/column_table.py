"""Any table of samples as a recording: its columns mapped to ours, converted, grouped or cut into trials."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from pointpred.columns import FloatArray
from pointpred.errors import ColumnsError, RecordingError
from pointpred.recording import Provenance, Recording, Skip
from pointpred.sources import tables, time_units
from pointpred.sources.assembly import IntArray
from pointpred.sources.clock_units import counts_frames, units_of
from pointpred.sources.column_mapping import KEYS, command_for, mapping, parts_of, unit_refusal
from pointpred.sources.column_names import near
from pointpred.sources.json_cells import open_cells
from pointpred.sources.list_rows import holds_lists, recording_of_lists
from pointpred.sources.reading import NEEDED, Reading
from pointpred.sources.table_buttons import buttons_of
from pointpred.sources.table_trials import TARGET, Rows, recording_of_rows
from pointpred.sources.trial_keys import codes_of
from pointpred.sources.trial_restarts import joined

MOSTLY = 0.5
"""A column of numbers in which a larger share of cells is none is the wrong column."""


OFTEN, FEW = 0.2, 3
"""A larger share, and more, of steps backwards is no clock that starts anew now and then."""


class ColumnTable(msgspec.Struct, frozen=True):
    """The cells of one table by column, all of one length.

    A cell is a str, a number, a bool, ``None``, a date and time, or a list of numbers (a row a trial);
    a column is a list, a numpy array or an Arrow array. ``format`` for the provenance. ``row_of``: the file's
    row of each row where some were left out, which ``skipped`` names.
    """

    columns: dict[str, Any]
    format: str
    notes: tuple[str, ...] = ()
    skipped: tuple[Skip, ...] = ()
    row_of: IntArray | None = None


def recording_of_table(path: Path, table: ColumnTable, reading: Reading) -> Recording:
    """The recording in a table, by ``reading.columns`` or the usual names of columns.

    Says in a note what was assumed. Raises ColumnsError, which names the columns and a mapping to try, where
    no mapping is certain, and RecordingError where a mapped column is not what it should be.
    """
    columns, damage = open_cells(table.columns)
    table = msgspec.structs.replace(table, columns=columns, notes=(*table.notes, *damage))
    names = list(table.columns)
    sizes = {len(column) for column in table.columns.values()}
    if len(sizes) > 1:
        raise RecordingError(
            f"{path}: columns of {min(sizes)} to {max(sizes)} rows, expected as many of each"
        )
    for name, parts in parts_of(path, names, reading).items():
        table.columns[name] = joined([as_arrow(table.columns[part]) for part in parts])
    names = list(table.columns)
    arrays: dict[str, Any] = {}

    def column(name: str) -> Any:
        if name not in arrays:
            arrays[name] = as_arrow(table.columns[name])
        return arrays[name]

    def same(some: Sequence[str]) -> bool:
        return all(_part_alike(column(some[0]), column(other)) for other in some[1:])

    def units(name: str) -> list[str]:
        return units_of(name, column(name), reading.time_unit)[0]

    found, notes = mapping(path, names, reading, same, units)
    count = sizes.pop() if sizes else 0
    if any(holds_lists(column(found[field])) for field in NEEDED):
        return _of_lists(path, table, reading, column, found, notes)
    rows = Rows(count, np.arange(count, dtype=np.int64) if table.row_of is None else table.row_of)
    unit, how = _unit(path, names, found, column(found["t"]), reading)
    iso = unit == "iso"
    rows.values["t"], wrong = time_units.clock(column(found["t"]), iso)
    rows.blame("t", found["t"], wrong, "a date and time" if iso else "a number")
    rows.per_second = time_units.PER_SECOND[unit]
    gains = _gains(reading)
    for field in ("x", "y", "dx", "dy", *TARGET):
        if field in found:
            numbers, wrong = tables.finite_numbers(column(found[field]))
            with np.errstate(over="ignore"):  # what overflows is judged with its row
                rows.values[field] = numbers * gains.get(field, 1.0) + 0.0  # no negative zero
            if field not in TARGET:
                rows.blame(field, found[field], wrong, "a number")
    for field in NEEDED:
        _check_numbers(path, names, found, field, rows.values[field], column(found[field]))
    if "buttons" in found:
        told = "buttons" in (reading.columns or {})
        pressed = buttons_of(path, found["buttons"], column(found["buttons"]), told)
        if pressed is None:
            notes.append(f"column {found['buttons']} is left aside: its cells are not buttons")
            del found["buttons"]
        else:
            rows.values["buttons"] = pressed
    keys = {key: pc.utf8_trim_whitespace(tables.words(column(found[key]))) for key in KEYS if key in found}
    if "trial" not in keys:
        _check_clock(path, names, found, rows.values["t"], keys.get("user"))
    return recording_of_rows(
        path,
        rows,
        keys,
        {name: column(name) for name in names if name not in found.values()},
        reading,
        provenance=_provenance(table, reading, found, how),
        skipped=table.skipped,
        notes=(*table.notes, _mapped(found, how), *notes),
    )


def _of_lists(
    path: Path,
    table: ColumnTable,
    reading: Reading,
    column: Callable[[str], Any],
    found: dict[str, str],
    notes: Sequence[str],
) -> Recording:
    """The recording in a table with a trial a row; raises ColumnsError."""
    names = list(table.columns)
    lacking = [field for field in NEEDED if not holds_lists(column(found[field]))]
    if lacking:
        some = ", ".join(found[field] for field in lacking)
        said = f"t, x and y must be lists alike; {some} holds none"
        raise ColumnsError(f"{path}: {said}", names, found, reason=said)
    unit, how = _unit(path, names, found, column(found["t"]), reading)
    gains = _gains(reading)
    return recording_of_lists(
        path,
        column,
        found,
        [name for name in names if name not in found.values()],
        per_second=time_units.PER_SECOND[unit],
        gain=(gains["x"], gains["y"]),
        provenance=_provenance(table, reading, found, how),
        skipped=table.skipped,
        notes=(*table.notes, _mapped(found, how), *notes),
    )


def _gains(reading: Reading) -> dict[str, float]:
    """What x, y and the target are multiplied by."""
    gain = reading.px_per_unit or 1.0
    turned = -gain if reading.y_up else gain
    return {"x": gain, "y": turned, "target_x": gain, "target_y": turned, "target_w": gain}


def _mapped(found: dict[str, str], how: str) -> str:
    """The mapping as a note."""
    return "columns: " + ", ".join(
        f"{field} = {name}" + (how if field == "t" else "") for field, name in found.items()
    )


def _provenance(table: ColumnTable, reading: Reading, found: dict[str, str], how: str) -> Provenance:
    return Provenance(
        table.format,
        unit="px" if reading.px_per_unit is None else f"units of {reading.px_per_unit:g} px",
        origin="as in the file",
        y_axis="up" if reading.y_up else "down",
        clock=f"column {found['t']}{how}",
        dpi=reading.dpi,
        cpi=reading.cpi,
    )


def as_arrow(column: Any) -> Any:
    """A column as an Arrow array; cells of several kinds become words."""
    if isinstance(column, pa.ChunkedArray):
        return column
    try:
        array = pa.array(column)
    except (pa.ArrowException, TypeError, ValueError, OverflowError):
        array = pa.array([None if cell is None else str(cell) for cell in column], pa.string())
    if pa.types.is_null(array.type):
        array = pc.cast(array, pa.string())
    return pa.chunked_array([array])


def _unit(
    path: Path, names: Sequence[str], found: dict[str, str], column: Any, reading: Reading
) -> tuple[str, str]:
    """The unit of time, and how it is known, as notes say it; raises ColumnsError where it is not known."""
    units, how = units_of(found["t"], column, reading.time_unit)
    if len(units) != 1:
        raise unit_refusal(path, names, found, units, reading, counts_frames(column))
    return units[0], how


def _check_numbers(
    path: Path, names: Sequence[str], found: dict[str, str], field: str, values: FloatArray, column: Any
) -> None:
    """Raise ColumnsError where most cells of a column are no numbers."""
    bad = int(np.count_nonzero(~np.isfinite(values)))
    if bad <= MOSTLY * len(values):
        return
    row = int(np.flatnonzero(~np.isfinite(values))[0])
    cell = tables.short(str(column[row].as_py()))
    said = f"{bad} of {len(values)} cells of the column {found[field]!r} ({field}) are no number"
    raise ColumnsError(
        f"{path}: {said}, such as {cell!r} in data row {row}: is it another column, or another unit of time?",
        names,
        found,
        reason=said,
    )


def _check_clock(
    path: Path, names: Sequence[str], found: dict[str, str], clock: FloatArray, users: Any
) -> None:
    """Raise ColumnsError where the time of a stream goes backwards so often that it holds intervals."""
    if users is not None:
        clock = clock[np.argsort(codes_of(pc.fill_null(users, ""))[0], kind="stable")]
    steps = np.diff(clock[np.isfinite(clock)])
    back = int(np.count_nonzero(steps < 0))
    if back > max(OFTEN * len(steps), FEW):
        rest = {field: name for field, name in found.items() if field != "t"}
        likely = near([name for name in names if name not in found.values()]).get("t", "COLUMN")
        raise ColumnsError(
            f"{path}: the time (column {found['t']!r}) goes backwards in {back} of {len(steps)} steps: "
            f"does it hold intervals? try: {command_for(path, rest | {'t': likely})}; where it is the time "
            "of each trial, name the column of the trials: --columns trial=...",
            names,
            rest,
        )


def _part_alike(one: Any, other: Any) -> bool:
    """Whether two columns part the rows into the same groups."""
    codes = [codes_of(pc.fill_null(tables.words(column), ""))[0] for column in (one, other)]
    together = len(np.unique(codes[0] * (codes[1].max(initial=0) + 1) + codes[1]))
    return together == len(np.unique(codes[0])) == len(np.unique(codes[1]))
