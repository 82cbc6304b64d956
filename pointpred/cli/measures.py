"""``pointpred measures``: recordings in, a row a trial out, and throughput by person and condition."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isfinite
from pathlib import Path
from typing import Annotated, Any

import msgspec
import typer

from pointpred.cli.output_files import Force, Numbers, check_targets, write_json
from pointpred.cli.reading_options import Reasons, as_given, in_memory, to_read, with_reading
from pointpred.console import NARROW, counted, plain, remark, remarks, results, table
from pointpred.errors import ParameterError, RecordingError
from pointpred.extras import require
from pointpred.recording import Recording, Skip, kinds_of
from pointpred.recordings.reading import Reading

TABLES, FIGURES = (".csv", ".parquet"), (".svg", ".png", ".pdf")
MOST_ROWS = 24
"""Rows of a table that are printed; the document has all."""
ALIKE = 1.5
"""Targets of one condition are at most so many times further than others."""
SHOWN = {
    "trials": "trials",
    "error_rate": "errors",
    "response_time_s": "time, s",
    "id_bits": "ID, bits",
    "throughput_bits_s": "throughput, bits/s",
}
NARROWED = {"id_bits": "ID", "throughput_bits_s": "bits/s"}
"""What columns are called in a narrow terminal."""
MEDIANS = {
    "response_time_s": ("from start to selection", "{:.2f} s"),
    "initiation_time_s": ("until the onset", "{:.2f} s"),
    "path_px": ("path", "{:.0f} px"),
    "mad_px": ("largest deviation", "{:.0f} px"),
    "peak_speed_px_s": ("peak speed", "{:.0f} px/s"),
}


class SetMeasures(msgspec.Struct, frozen=True):
    """A recording in ``--json``; ``throughput`` and what follows are empty where no target is known."""

    name: str
    trials: int
    users: int
    simulated: bool
    skipped: tuple[Skip, ...]
    throughput: dict[str, Any] | None
    """The mean over people of the means over their conditions, of each number of ``groups``."""
    regression: dict[str, Any] | None
    """Time from start to selection against the index of difficulty, a point a condition."""
    conditions: list[dict[str, Any]]
    people: list[dict[str, Any]]
    groups: list[dict[str, Any]]
    """A row a person and condition."""


@with_reading
def measures(
    files: Annotated[
        list[Path] | None,
        typer.Argument(
            callback=to_read,
            parser=as_given,
            help="Recordings in any format pointpred reads, or any table of samples; 'sample', or none: the "
            "embedded sample.",
        ),
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Write the measures, a row a trial: .csv or .parquet."),
    ] = None,
    where: Annotated[
        str,
        typer.Option(metavar="RULE", help="Measure only trials that fit, as 'phase != practice'."),
    ] = "",
    by: Annotated[
        str | None,
        typer.Option(
            metavar="COLUMN[,COLUMN]",
            help="What makes a condition, beside the target's width: columns of the recording. Not given: "
            "all that vary within a person and are no outcome.",
        ),
    ] = None,
    plot: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Draw time against difficulty: .svg, .png or .pdf."),
    ] = None,
    json: Numbers = None,
    force: Force = False,
    *,
    reading: Reading,
) -> None:
    """Measure recorded movements: times, speeds, paths, sub-movements, accuracy, errors and throughput.

    Prints throughput (ISO 9241-411, MacKenzie) by condition and person, and the line of time against the
    index of difficulty. A measure of deviation is from the straight line from start to end.

    Try:

      pointpred measures

      pointpred measures study_samples.parquet --out trials.csv

      pointpred measures *.sd3 --by A,Block --plot fitts.svg

      pointpred measures study_samples.parquet --where 'phase != practice' --plot fitts.pdf

      pointpred measures my.csv --columns t=time,x=px,y=py,user=sid,trial=n --time-unit ms --out t.csv
    """
    check_targets({"--out": out, "--plot": plot, "--json": json}, files or (), force)
    for option, file, endings in (("--out", out, TABLES), ("--plot", plot, FIGURES)):
        if file is not None and file.suffix not in endings:
            message = f"{option} must name a file that ends in {', '.join(endings)}, received {file}"
            raise ParameterError(message, field=option[2:], value=str(file))
    if plot is not None:
        require("report", "--plot")
    from pointpred.measures import movements, table_of
    from pointpred.recordings.read_files import readable
    from pointpred.scoring.selection import where_of

    rule = where_of(where) if where else None
    known: list[tuple[str, bool, tuple[Skip, ...]]] = []
    reasons: Reasons = {}

    def measured() -> Iterator[tuple[str, Sequence[Any]]]:
        for recording in in_memory(files, reading, reasons) if files else _sample():
            found, skipped = movements(recording)
            if rule is not None:
                fits = rule.picked([one.trial for one in found]) if found else ()
                picked = [one for one, fit in zip(found, fits, strict=True) if fit]
                remark(f"{recording.name}: {rule.about(len(picked), len(found))}")
                found = picked
            known.append((recording.name, recording.provenance.simulated, skipped))
            yield recording.name, found

    trials = table_of(measured())
    columns = None if by is None else [part.strip() for part in by.split(",") if part.strip()]
    sets = [_summary(trials, columns, *about) for about in known]
    if out is not None:
        _write(trials, out)
    if plot is not None:
        from pointpred.measures.plot import draw_lines

        lines = {one.name: (one.conditions, one.regression) for one in sets if one.conditions}
        if not lines:
            raise RecordingError("nothing to draw: no trial says where its target was and how wide")
        draw_lines(lines, plot)
    if json is not None:
        unread = [{"file": readable(file), "reason": readable(why)} for file, why in reasons.items()]
        write_json({"version": 1, "sets": sets, "unread": unread}, json)
    if json is None or str(json) != "-":
        for one in sets:
            _print(one, trials)
    for written, file in (("measures", out), ("drawn", plot)):
        if file is not None:
            remark(f"{written}: {file}")
    if not len(trials):
        raise RecordingError("no trial could be measured; see the reasons above", code="nothing_scored")


def _sample() -> Iterator[Recording]:
    from pointpred.datasets import sample

    remarks().print("No recording given: measuring the embedded sample of simulated people.")
    yield sample()


def _write(trials: Any, out: Path) -> None:
    """The table as CSV, or as Parquet."""
    import pyarrow.csv
    import pyarrow.parquet

    from pointpred.files import whole

    with whole(out) as stream:
        if out.suffix == ".csv":
            pyarrow.csv.write_csv(trials, stream, pyarrow.csv.WriteOptions(quoting_style="needed"))
        else:
            pyarrow.parquet.write_table(trials, stream)


def _of_set(trials: Any, name: str) -> Any:
    import pyarrow.compute as pc

    return trials.filter(pc.equal(trials["dataset"], name))


def _summary(
    trials: Any, by: list[str] | None, name: str, simulated: bool, skipped: tuple[Skip, ...]
) -> SetMeasures:
    """Throughput of one recording, by person and condition, person, condition, and all in all."""
    from pointpred.measures import fitts

    own = _of_set(trials, name)
    groups = fitts.throughput(own, by)
    made = fitts.conditions_of(groups)
    people = fitts.means(groups, ["dataset", "user"])
    whole = fitts.means(people, ["dataset"]).to_pylist()
    line = fitts.fitts_line(groups)
    _warn(own, groups, name)
    return SetMeasures(
        name,
        len(own),
        len(own["user"].unique()),
        simulated,
        skipped,
        whole[0] if whole else None,
        None if line is None else msgspec.to_builtins(line),
        fitts.means(groups, made).sort_by([(name, "ascending") for name in made]).to_pylist(),
        people.to_pylist(),
        groups.to_pylist(),
    )


def _warn(trials: Any, groups: Any, name: str) -> None:
    """Say where conditions hold too little for a throughput, or targets that are not alike."""
    from pointpred.measures import fitts

    alone = sum(count == 1 for count in groups["trials"].to_pylist())
    if alone:
        remark(
            f"{name}: {alone} of {len(groups)} conditions of a person hold one trial, which has no "
            "throughput; name other conditions with --by"
        )
    keys = ["user", *fitts.conditions_of(groups)]
    wanted = [("target_distance_px", "min"), ("target_distance_px", "max")]
    ranges = trials.group_by(keys).aggregate(wanted)
    ends = [ranges[f"target_distance_px_{end}"].to_pylist() for end in ("min", "max")]
    unlike = [(low, high) for low, high in zip(*ends, strict=True) if low and high > ALIKE * low]
    if unlike:
        low, high = min(low for low, _ in unlike), max(high for _, high in unlike)
        remark(
            f"{name}: {len(unlike)} of {len(groups)} conditions of a person hold targets at distances that "
            f"differ ({low:.0f} to {high:.0f} px): name the column of distances or blocks with --by"
        )


def _print(one: SetMeasures, trials: Any) -> None:
    from pointpred.measures.fitts import GROUP

    screen = results()
    for kind, some in kinds_of(one.skipped):
        remark(f"{one.name}: skipped {len(some)}: {kind} (first: {some[0].place})")
    noun = "person" if one.users == 1 else "people"
    people = f"{one.users} {'simulated ' if one.simulated else ''}{noun}"
    screen.print(f"{one.name}: {counted(one.trials, 'trial')}, {people}", style="bold")
    if not one.trials:
        return
    screen.print(_medians(_of_set(trials, one.name)))
    if one.throughput is None:
        remark(f"{one.name}: no trial says where its target was and how wide: no throughput")
        return
    factors = [name for name in one.conditions[0] if name not in (*GROUP, "dataset", "people")]
    if any(name.lower().startswith("width") or name == "W" for name in factors):
        factors.remove("target_w")
    _print_rows(one.conditions, {name: name for name in factors})
    _print_rows(one.people, {"user": "person"})
    total = one.throughput
    screen.print(
        f"all: {total['error_rate']:.1%} errors, {total['response_time_s']:.3f} s, "
        f"{_cell('throughput_bits_s', total['throughput_bits_s'])} bits/s "
        "(means over people of their means over conditions)",
    )
    if line := one.regression:
        screen.print(
            f"time = {line['intercept']:.3f} s + {line['slope']:.3f} s/bit x ID, R2 = {line['r2']:.3f}, "
            f"{counted(line['points'], 'condition')}",
        )
    screen.print(
        "Time from start to selection; ID = log2(distance / width + 1); throughput by effective width and "
        "distance.\nEach person and condition, ISO 9241-411, bivariate: --json FILE; each trial: --out FILE",
        style="dim",
    )


def _medians(trials: Any) -> str:
    import pyarrow.compute as pc

    said = []
    for name, (words, form) in MEDIANS.items():
        median = pc.quantile(pc.abs(trials[name]))[0].as_py()
        said += [] if median is None else [f"{words} {form.format(median)}"]
    return f"medians: {', '.join(said)}"


def _print_rows(rows: list[dict[str, Any]], factors: dict[str, str]) -> None:
    """A table of the first rows; what does not fit a narrow terminal is called by shorter names."""
    narrow = results().width < NARROW
    names = factors | {name: NARROWED.get(name, words) if narrow else words for name, words in SHOWN.items()}
    cells = [[_cell(name, row[name]) for name in names] for row in rows[:MOST_ROWS]]
    headings = list(names.values())
    results().print(table(headings, cells, whole=headings, right=headings[len(factors) :]))
    if len(rows) > MOST_ROWS:
        results().print(f"and {len(rows) - MOST_ROWS} more: --json FILE", style="dim")


def _cell(name: str, value: Any) -> str:
    if value is None or (isinstance(value, float) and not isfinite(value)):
        return "-"
    if name in ("error_rate", "response_time_s", "id_bits", "throughput_bits_s"):
        return f"{value:.1%}" if name == "error_rate" else f"{value:.2f}"
    return f"{value:g}" if isinstance(value, float) else plain(str(value))
