"""Template matching in its own protocol, beside any predictor: writes ``docs/evidence/ktm.md``.

``python -m pages.ktm.measure [name ...]`` takes the embedded sample and every set in the folder that
POINTPRED_RECORDINGS names. Beside template matching stand the names given, all of the registry without any;
what was trained on a set stands in docs/evidence/results.md instead, with coefficients that did not see it.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path

from benchmarks.arguments import words
from benchmarks.ktm_cost import costs
from benchmarks.per_event import machine
from pages import DOCS
from pages.held_out import seen, trained
from pages.markdown import filled, table
from pages.sets import VARIABLE, recordings
from pointpred import REGISTRY, build
from pointpred.console import counted
from pointpred.recording import Recording
from pointpred.scoring import ktm_protocol as protocol
from pointpred.scoring import prepare, resolution
from pointpred.scoring.ktm_protocol import Drawn, Read

PAGE = DOCS / "evidence" / "ktm.md"
HEADER = ("predictor", *(f"{share:.0%}" for share in protocol.FRACTIONS), "of the distance", "skill", "hits")
FLOOR = "hold"


def read(drawn: Drawn, names: Sequence[str], settings: dict[str, float]) -> list[Read]:
    """Template matching with the library, and each name, on the drawn trials; the floor first."""
    others = [FLOOR, *(name for name in names if name != FLOOR)]
    beside = [protocol.without_library(drawn, build(name, **settings)) for name in others]
    return [beside[0], protocol.with_library(drawn), *beside[1:]]


def rows(results: Sequence[Read]) -> list[tuple[str, ...]]:
    """A row a predictor, the smallest error of each column in bold."""
    floor, best = results[0], [min(column) for column in zip(*(r.mean_px() for r in results), strict=True)]
    lines = []
    for one in results:
        errors = one.mean_px().tolist()
        px = [f"**{e:.0f}**" if e == least else f"{e:.0f}" for e, least in zip(errors, best, strict=True)]
        shares = " / ".join(f"{100 * share:.1f}" for share in one.share().tolist())
        skill = " / ".join(f"{100 * share:.0f}" for share in one.skill(floor).tolist())
        hits = " / ".join(f"{100 * share:.0f}" for share in one.hits().tolist())
        name = one.name if one.name == protocol.LIBRARY else f"`{one.name}`"
        lines.append((name, *px, f"{shares} %", f"{skill} %", f"{hits} %"))
    return lines


RULES = ((True, "never nearer to the start again (published)"), (False, "all trials"))


def tested(recording: Recording, names: Sequence[str], monotone: bool) -> tuple[str, list[Read]]:
    """What was tested, in words, and the results; none where no user has enough movements."""
    settings = {k: v for k, v in resolution(recording, None, None).items() if v is not None}
    drawn = protocol.draw(prepare(recording, **settings), only_monotone=monotone, share=1.0)
    if not drawn.tested:
        return f"no user has {protocol.MOVEMENTS_LEAST} movements, or no movement may be tested", []
    known = trained() if recording.name in seen() else ()
    results = read(drawn, [name for name in names if name not in known], settings)
    sizes = sorted(len(library) - 1 for library in drawn.libraries.values())
    least = f"{sizes[0]} to " if sizes[0] < sizes[-1] else ""
    said = (
        f"{counted(len(drawn.tested), 'trial')} of {counted(len(drawn.libraries), 'user')}, "
        f"{least}{sizes[-1]} templates each, mean distance {results[0].distances.mean():.0f} px; "
        f"{len(drawn.left_out)} left out"
    )
    return said, results


def overview_row(name: str, results: Sequence[Read]) -> tuple[str, ...]:
    """Template matching with the library, and the best of the others at each share."""
    floor, matched, others = results[0], results[1], (results[0], *results[2:])
    skill = [f"{100 * value:.0f} %" for value in matched.skill(floor).tolist()]
    best = []
    for at in range(len(protocol.FRACTIONS)):
        one = min(others, key=lambda other: float(other.mean_px()[at]))
        best.append(f"`{one.name}` {one.mean_px()[at] / matched.mean_px()[at]:.2f}")
    return (name, *skill, *best)


def written(sets: Iterable[Recording], names: Sequence[str]) -> tuple[str, str]:
    """The overview and the sections of all sets, as Markdown."""
    lines, sections = [], []
    for recording in sets:
        title = f"{recording.name}{' (simulated)' if recording.provenance.simulated else ''}"
        parts = [f"### {title}"]
        for monotone, rule in RULES:
            said, results = tested(recording, names, monotone)
            print(f"{recording.name}, {rule}: {said}")
            parts.append(f"*{rule}*: {said}.")
            if results:
                parts.append(table(HEADER, rows(results)))
                lines += [overview_row(title, results)] if monotone else []
        sections.append("\n\n".join(parts))
    shares = [f"{share:.0%}" for share in protocol.FRACTIONS]
    header = ("set", *(f"skill at {s}" for s in shares), *(f"best other at {s}" for s in shares))
    return table(header, lines), "\n\n".join(sections)


def write(folder: Path | None, names: Sequence[str]) -> Path:
    """Run the protocol on every set and write the generated parts of the page."""
    unread: dict[str, str] = {}
    overview, sets = written(recordings(folder, unread), names)
    missing = [f"### {file}\n\nNot read: {why}" for file, why in unread.items()]
    page = PAGE.read_text(encoding="utf-8")
    page = filled(page, "overview", overview)
    page = filled(page, "sets", "\n\n".join([sets, *missing]))
    page = filled(page, "cost", f"{machine()}\n\n{costs()}")
    PAGE.write_text(page, encoding="utf-8")
    return PAGE


def main(arguments: Sequence[str]) -> None:
    """Write the page from all that is at hand."""
    named = os.environ.get(VARIABLE)
    if named is None:
        print(f"{VARIABLE} names no folder: only the embedded sample is used")
    elif not Path(named).is_dir():
        raise SystemExit(f"{VARIABLE} must name a folder, received {named!r}")
    print(f"wrote {write(Path(named) if named else None, arguments or list(REGISTRY))}")


if __name__ == "__main__":
    main(words(__doc__, named="predictor", known=list(REGISTRY)))
