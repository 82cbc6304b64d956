"""Throughput of people in conditions, and the line of movement time against the index of difficulty."""

from __future__ import annotations

from collections.abc import Sequence
from math import nan
from typing import Any

import msgspec
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from pointpred.errors import ParameterError
from pointpred.measures.trials import COLUMNS
from pointpred.records import FloatArray
from pointpred.scoring.statistics import MOST_VALUES, OUTCOMES

WIDTH_IN_SDS = 4.133
"""Width of the middle 96 % of a normal distribution, in standard deviations, as ISO 9241-411 prints it."""
LEAST_SPREAD = 1e-6
"""A spread below this share of the distance is rounding, and no effective width."""
LEAST_POINTS = 3
"""A line through two points explains everything."""
NO_CONDITIONS = (*OUTCOMES, "trial", "sequence", "movement", "attempt", "from_", "start")
"""Conditions that begin so are outcomes, numbers of trials, places and times."""
RESPONSE = "response_time_s"
FACTORS = ("dataset", "user", "target_w")
GROUP = (
    *("trials", "error_rate", "response_time_s", "movement_time_s", "target_distance_px", "id_bits"),
    *("effective_distance_px", "effective_width_px", "effective_id_bits", "throughput_bits_s"),
    *("iso_throughput_bits_s", "effective_width_2d_px", "throughput_2d_bits_s"),
)
"""What is known of a person in a condition, beside what the condition is."""


def conditions(table: Any) -> list[str]:
    """The columns of a table of trials that are conditions of an experiment.

    That is: what is no measure and known of every trial, varies within a person, and has several trials to
    each value of a person. Outcomes, places and numbers of trials are none by their names, nor are numbers
    with more than 12 values.
    """
    table = pa.table(table)
    users = table["user"]
    found = []
    for name in table.column_names:
        column = table[name]
        if name in COLUMNS or name.lower().startswith(NO_CONDITIONS) or column.null_count or not len(column):
            continue
        values = len(column.unique())
        pairs = pa.table({"user": users, "value": column}).group_by(["user", "value"]).aggregate([])
        measured = values > MOST_VALUES and not pa.types.is_string(column.type)
        if not measured and len(users.unique()) < len(pairs) <= len(column) / 2:
            found.append(name)
    return found


def throughput(table: Any, by: Sequence[str] | None = None, *, time: str = RESPONSE) -> pa.Table:
    """Throughput of each person in each condition: a row each, with what it is computed from.

    ``table``: of ``measure``, or a DataFrame of that. ``by``: the columns that make a condition, together
    with the target's width; ``None``: those of ``conditions``. ``time``: the column that is the movement
    time; of discrete tasks, whose time begins with the movement, ``"movement_time_s"``. Trials without a
    target are left out; misses count, since the effective width accounts for them.

    ``throughput_bits_s``: log2(Ae / We + 1) / MT, as MacKenzie computes it. MT is the mean time, Ae the mean
    distance from start to selection along the task axis, We = 4.133 SD of where the selections lie along it.
    ``iso_throughput_bits_s``: the same with the targets' distance instead of Ae (ISO 9241-411).
    ``throughput_2d_bits_s``: with the bivariate deviation, the root of the summed variances along and across
    the axis, and the mean straight distance from start to selection. Empty where there is no spread.

    Raises ParameterError for a column that is not there.

    Reference: Soukoreff and MacKenzie 2004, Towards a standard for pointing device evaluation; MacKenzie
    2015, Fitts' throughput and the remarkable case of touch-based target selection; ISO 9241-411:2012;
    Wobbrock, Shinohara and Jansen 2011, The effects of task dimensionality, endpoint deviation, throughput
    calculation, and experiment design on pointing measures and models.
    """
    table = pa.table(table)
    for name in (*(by or ()), time):
        if name not in table.column_names:
            others = [one for one in table.column_names if one not in COLUMNS]
            known = ", ".join(others) or "none"
            raise ParameterError(f"no column {name!r}; the conditions are: {known}", field="by", value=name)
    keys = list(dict.fromkeys([*FACTORS[:2], *(conditions(table) if by is None else by), FACTORS[2]]))
    table = table.filter(pc.is_valid(table["id_bits"]))
    table = table.set_column(
        table.column_names.index("error"), "error", table["error"].cast(pa.int8()).cast(pa.float64())
    )
    table = table.append_column("row", pa.array(range(len(table)), pa.int64()))
    spread = pc.VarianceOptions(ddof=1)
    averaged = list(dict.fromkeys((RESPONSE, "movement_time_s", time)))
    averaged += ["error", "target_distance_px", "id_bits", "effective_distance_px", "amplitude_px"]
    grouped = (
        table.group_by(keys, use_threads=False)
        .aggregate(
            [
                ("row", "min"),
                ([], "count_all"),
                *((name, "mean") for name in averaged),
                *((name, "variance", spread) for name in ("end_along_px", "end_across_px")),
            ]
        )
        .sort_by("row_min")
    )
    mean = {name: _numbers(grouped[f"{name}_mean"]) for name in averaged}
    along, across = (_numbers(grouped[f"end_{axis}_px_variance"]) for axis in ("along", "across"))
    width, width_2d = WIDTH_IN_SDS * np.sqrt(along), WIDTH_IN_SDS * np.sqrt(along + across)
    bits, took = _bits(mean["effective_distance_px"], width), np.where(mean[time] > 0.0, mean[time], nan)
    values = {
        "trials": _numbers(grouped["count_all"]),
        "error_rate": mean["error"],
        **{name: mean[name] for name in averaged if name in GROUP},
        "effective_width_px": width,
        "effective_id_bits": bits,
        "throughput_bits_s": bits / took,
        "iso_throughput_bits_s": _bits(mean["target_distance_px"], width) / took,
        "effective_width_2d_px": width_2d,
        "throughput_2d_bits_s": _bits(mean["amplitude_px"], width_2d) / took,
    }
    made = {name: pa.array(values[name], from_pandas=True) for name in GROUP}
    made["trials"] = made["trials"].cast(pa.int64())
    return pa.table({name: grouped[name] for name in keys} | made)


def _numbers(column: Any) -> FloatArray:
    """A column as floats, NaN where it is empty."""
    array: FloatArray = column.cast(pa.float64()).to_numpy()
    return array


def _bits(distance: FloatArray, width: FloatArray) -> FloatArray:
    """The index of difficulty, bits; NaN where it is not defined."""
    sound = (distance > 0.0) & (width > LEAST_SPREAD * distance)
    ratio: FloatArray = np.divide(distance, width, out=np.full(len(distance), nan), where=sound)
    return np.log2(ratio + 1.0, dtype=np.float64)


def means(groups: pa.Table, by: Sequence[str]) -> pa.Table:
    """The mean of each number of ``throughput`` over its rows that have the same ``by``; trials are summed.

    Over conditions with ``by=["dataset", "user"]``, then over people with ``by=["dataset"]``: the mean of
    means of Soukoreff and MacKenzie 2004, equation 6. ``people`` is how many people the rows are of.
    """
    names = [name for name in GROUP if name != "trials"]
    wanted = [("user", "count_distinct"), ("trials", "sum"), *((name, "mean") for name in names)]
    made = groups.group_by(list(by), use_threads=False).aggregate(wanted)
    columns = {name: made[name] for name in by} | {"people": made["user_count_distinct"]}
    return pa.table(columns | {"trials": made["trials_sum"]} | {name: made[f"{name}_mean"] for name in names})


class Line(msgspec.Struct, frozen=True):
    """A least-squares line: ``intercept`` and ``slope``, the share of variance explained, its points."""

    intercept: float
    slope: float
    r2: float
    points: int


def line(x: FloatArray, y: FloatArray) -> Line | None:
    """The least-squares line of y against x; ``None`` with fewer than three points or a single x.

    >>> line(np.array([1.0, 2.0, 3.0]), np.array([3.0, 5.0, 7.0]))
    Line(intercept=1.0, slope=2.0, r2=1.0, points=3)
    """
    known = np.isfinite(x) & np.isfinite(y)
    x, y = x[known], y[known]
    if len(x) < LEAST_POINTS or np.ptp(x) == 0.0:
        return None
    right, up = x - x.mean(), y - y.mean()
    slope = float(right @ up / (right @ right))
    total = float(up @ up)
    r2 = float((right @ up) ** 2 / ((right @ right) * total)) if total else nan
    return Line(float(y.mean() - slope * x.mean()), slope, r2, len(x))


def fitts_line(groups: pa.Table, *, time: str = RESPONSE, difficulty: str = "id_bits") -> Line | None:
    """Movement time s against the index of difficulty bits, a point a condition: the mean over its people.

    ``groups``: of ``throughput``. ``difficulty``: ``"id_bits"`` of the targets, log2(distance / width + 1),
    or ``"effective_id_bits"``, which Soukoreff and MacKenzie 2004 recommend. R² of means is higher than that
    of single people; ``line`` fits any two columns.

    Reference: Fitts 1954; MacKenzie 1992, Fitts' law as a research and design tool (Shannon's formulation).
    """
    points = means(groups, conditions_of(groups))
    return line(_numbers(points[difficulty]), _numbers(points[time]))


def conditions_of(groups: pa.Table) -> list[str]:
    """What makes a condition in a table of ``throughput``: every column but the person and the numbers."""
    return [name for name in groups.column_names if name not in (*GROUP, "user")]
