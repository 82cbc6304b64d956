"""``pointpred train``: coefficients of `kinematic` fitted to one's own recordings."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import msgspec
import typer

from pointpred.cli.output_files import Force, Numbers, Seed, check_targets, write_json
from pointpred.cli.reading_options import as_given, in_memory, to_read, with_reading
from pointpred.cli.shared_options import ClusterAddress, Threads
from pointpred.console import counted, plain, results, table
from pointpred.errors import ParameterError, RecordingError
from pointpred.extras import require
from pointpred.predictors.kinematic import coefficient_file
from pointpred.recordings.reading import Reading

if TYPE_CHECKING:
    from pointpred.training.train import TrainingResult

HEADINGS = ("recording", "movements", "hold", "shipped", "yours", "yours / shipped (95 %)")
VERDICT = {
    1: "Your coefficients are better than the shipped ones on movements that they were not fitted to.",
    0: "Your coefficients are not clearly better than the shipped ones on movements that they were not "
    "fitted to:\nthe interval holds 1, or recordings disagree. More recordings would tell.",
    -1: "Your coefficients are worse than the shipped ones on movements that they were not fitted to: "
    "keep the shipped ones.",
}
HELD_OUT = {
    "people": "people held out",
    "recordings": "recordings held out, which may be of one person",
    "movements": "movements of one person held out, in order",
}


@with_reading
def train(
    files: Annotated[
        list[Path],
        typer.Argument(
            callback=to_read, parser=as_given, help="Recordings, as 'pointpred score' reads them."
        ),
    ],
    out: Annotated[Path, typer.Option(metavar="FILE", help="The file to write, such as me.npz.")],
    seed: Seed = 1,
    threads: Threads = None,
    cluster: ClusterAddress = None,
    json: Numbers = None,
    force: Force = False,
    *,
    reading: Reading,
) -> None:
    """Fit the coefficients of 'kinematic' to your own recordings, and score them beside the shipped ones.

    Scores are of movements that were held out: other people's, or other movements where there is one person.
    The same user name in several recordings is the same person.
    It needs at least 50 movements, and the extra 'train', which brings scipy: where it is missing, an error
    shows the command that installs it.

    The file is for --coefficients and build("kinematic", coefficients=...).

    Try:

      pointpred train session.csv --out me.npz

      pointpred score other.csv --predictors kinematic --coefficients me.npz
    """
    check_targets({"--out": out, "--json": json}, files, force)
    if str(out) == "-" or out.suffix != ".npz":
        message = f"--out must name a file that ends in .npz, received {out}"
        raise ParameterError(message, field="out", value=str(out))
    coefficient_file.check_writable(out)
    require("train", "training")  # before minutes of reading
    from pointpred.cli.progress import following
    from pointpred.scoring.executors import open_executor
    from pointpred.training.train import train_custom

    with (
        open_executor(threads=threads, cluster=cluster) as executor,
        following() as advance,
    ):
        recordings = [one for one in in_memory(files, reading, {}) if one.trials]
        if not recordings:
            raise RecordingError("no recording to learn from could be read; see the reasons above")
        trained = train_custom(
            recordings,
            out,
            seed=seed,
            progress=advance or (lambda what, done, total: None),
            executor=executor,
        )
    if json is not None:
        write_json(document(trained, out), json)
    if json is None or str(json) != "-":
        _print(trained, out)


class TrainedSet(msgspec.Struct, frozen=True):
    """Time-averaged errors on one recording, means over movements that were held out, px."""

    name: str
    movements: int
    hold_px: float
    shipped_px: float
    own_px: float
    ratio: float
    """Own over shipped, with the bounds of its interval; ``None`` where there is none."""
    low: float | None
    high: float | None
    shipped_saw_it: bool
    """Whether the shipped coefficients were fitted to these people."""


class TrainDocument(msgspec.Struct, frozen=True):
    """What ``pointpred train --json`` writes."""

    version: int
    out: str
    movements: int
    people: int
    held_out: str
    """``people``, ``recordings`` or ``movements``."""
    better: int
    """As ``TrainingResult.better``."""
    sets: tuple[TrainedSet, ...]


def document(result: TrainingResult, out: Path) -> TrainDocument:
    """The scores as JSON has them."""
    from pointpred.scoring.summary.document import number

    return TrainDocument(
        1,
        str(out),
        result.movements,
        result.people,
        result.parts,
        result.better,
        tuple(
            TrainedSet(
                one.name,
                len(one.hold),
                float(one.hold.mean()),
                float(one.shipped.mean()),
                float(one.own.mean()),
                one.ratio[0],
                number(one.ratio[1]),
                number(one.ratio[2]),
                one.seen,
            )
            for one in result.held_out
        ),
    )


def _print(trained: TrainingResult, out: Path) -> None:
    screen = results()
    screen.print(f"{counted(trained.movements, 'movement')}; {HELD_OUT[trained.parts]}", style="bold")
    rows = []
    for one in trained.held_out:
        ratio, low, high = one.ratio
        means = (f"{errors.mean():.1f}" for errors in (one.hold, one.shipped, one.own))
        rows.append((plain(one.name), str(len(one.hold)), *means, f"{ratio:.3f} ({low:.3f}-{high:.3f})"))
    screen.print(table(HEADINGS, rows, whole=HEADINGS[:1], right=HEADINGS[1:]))
    screen.print(
        "Time-averaged error, px, of movements that were held out; hold predicts nothing.", style="dim"
    )
    screen.print(VERDICT[trained.better])
    if seen := [one.name for one in trained.held_out if one.seen]:
        words = f"The shipped coefficients were fitted to {', '.join(seen)}: their error there is too small."
        screen.print(words, style="red")
    screen.print(f"written: {out}", soft_wrap=True)
