"""Templates: the words of a page, with the numbers of its JSON put in.

A made part of a page that is written by people stands between two comments, ``<!-- generated: NAME -->`` and
``<!-- end -->``.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cache
from math import isfinite
from statistics import median
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from evidence import EVIDENCE
from evidence.data import Table

PART = r"<!-- generated: {name} -->\n.*?<!-- end -->"


@cache
def environment() -> Environment:
    """The templates of all pages; a name that a page's data lack is an error."""
    templates = Environment(
        loader=FileSystemLoader(EVIDENCE),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,  # Markdown, made from the project's own numbers
    )
    templates.filters |= {
        "shown": shown,
        "only": only,
        "columns": columns,
        "beside": beside,
        "turned": turned,
        "number": number,
        "share": share,
        "spread": spread,
        "span": span,
        "median_and_ends": median_and_ends,
        "percent": percent,
        "percents": percents,
        "times": times,
        "names": names,
    }
    templates.globals |= {"table": table, "missing": missing}
    return templates


def rendered(template: str, values: Mapping[str, Any]) -> str:
    """A template of the folder ``evidence`` with its values."""
    text = environment().get_template(template).render(values)
    text = re.sub(r"(?<=\|\n)\n+(?=\|)", "", text)  # a table has no empty lines
    return re.sub(r"\n{3,}", "\n\n", text).strip() + "\n"


def shown(one: Table) -> str:
    """A table as Markdown."""
    return table(tuple(one.columns), [tuple(row) for row in one.texts()])


def only(one: Table, **wanted: str | Sequence[str]) -> Table:
    """The rows whose cells, by column, are those wanted; the columns that are then all alike go."""
    texts, columns = one.texts(), one.columns
    chosen = {
        columns.index(name): {cells} if isinstance(cells, str) else set(cells)
        for name, cells in wanted.items()
    }
    rows = [i for i, row in enumerate(texts) if all(row[at] in cells for at, cells in chosen.items())]
    alike = {at for at, cells in chosen.items() if len(cells) == 1}
    places = [at for at in range(len(columns)) if at not in alike]
    return Table(
        [columns[at] for at in places],
        [one.decimals[at] for at in places],
        [[one.rows[i][at] for at in places] for i in rows],
    )


def columns(one: Table, *names: str) -> Table:
    """Some columns, in this order."""
    places = [one.columns.index(name) for name in names]
    return Table(
        list(names), [one.decimals[at] for at in places], [[row[at] for at in places] for row in one.rows]
    )


def beside(one: Table, other: Table, keys: int = 1) -> Table:
    """Two tables as one, where the first cells of their rows, ``keys`` of them, are the same."""
    more = {tuple(row[:keys]): row[keys:] for row in other.rows}
    return Table(
        [*one.columns, *other.columns[keys:]],
        [*one.decimals, *other.decimals[keys:]],
        [[*row, *more[tuple(row[:keys])]] for row in one.rows],
    )


def turned(one: Table) -> Table:
    """A row for each column, for tables of many columns and few rows."""
    head, *rows = zip(one.columns, *one.texts(), strict=True)
    return Table(list(head), [None] * len(head), [list(row) for row in rows])


def number(value: float | None, digits: int = 2) -> str:
    """A number, or a dash where there is none."""
    return "-" if value is None or not isfinite(value) else f"{value:.{digits}f}"


def share(measure: Any) -> str:
    """A ratio with its interval."""
    return spread(measure.of_hold, measure.interval)


def spread(value: float | None, interval: Sequence[float] | None, digits: int = 2) -> str:
    """A number with its interval in brackets."""
    if interval is None:
        return number(value, digits)
    return f"{number(value, digits)} [{number(interval[0], digits)}, {number(interval[1], digits)}]"


def span(values: Sequence[float], digits: int = 2) -> str:
    """The least and the most of several numbers, one number where both are shown alike."""
    ends = dict.fromkeys((number(min(values), digits), number(max(values), digits)))
    return " to ".join(ends)


def median_and_ends(values: Sequence[float]) -> str:
    """The median of several numbers, in brackets the least and the most."""
    return f"{number(median(values))} ({span(values)})"


def missing(short: Mapping[str, float]) -> str:
    """By how much what is wanted is missed: what is above 0 of the differences."""
    missed = [f"{what} {number(by)}" for what, by in short.items() if by > 0]
    return f"Missing: {'; '.join(missed)}." if missed else "Nothing is missing."


def percent(value: float | None, digits: int = 0) -> str:
    """A share in percent, without the sign."""
    return number(None if value is None else 100 * value, digits)


def percents(values: Sequence[float | None], digits: int = 0) -> str:
    """Several shares in percent."""
    return " / ".join(percent(value, digits) for value in values)


def times(count: int, noun: str) -> str:
    """A number of things: ``1 trial``, ``2 trials``, ``1 person``, ``2 people``."""
    many = {"person": "people"}.get(noun, f"{noun}s")
    return f"{count} {noun if count == 1 else many}"


def names(listed: Sequence[str]) -> str:
    """Names of predictors, as code."""
    return ", ".join(f"`{name}`" for name in listed)


def table(header: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    """A Markdown table."""
    lines = [header, tuple("---" for _ in header), *rows]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)


def filled(page: str, name: str, text: str) -> str:
    """The page with one part replaced; raises ValueError where the page has no such part."""
    part = f"<!-- generated: {name} -->\n\n{text}\n\n<!-- end -->"
    result, count = re.subn(PART.format(name=re.escape(name)), lambda _: part, page, flags=re.DOTALL)
    if count != 1:
        raise ValueError(f"expected one part {name!r}, found {count}")
    return result
