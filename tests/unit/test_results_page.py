"""The results page shows every set with the numbers of its JSON, and says what they say together."""

from __future__ import annotations

from pathlib import Path

import msgspec
import numpy as np
import pytest

from evidence import data
from evidence.rendering import rendered
from evidence.results import measure, page
from evidence.results.records import SetResults, stored
from pointpred import EventColumns
from pointpred.errors import ParameterError
from pointpred.recording import Recording, Trial
from pointpred.recordings import write
from pointpred.scoring import SetSummary
from pointpred.scoring.summary import Measure, PredictorSummary


def recording(name: str) -> Recording:
    random = np.random.default_rng(12)
    s = np.linspace(0.0, 1.0, 40)
    way = s**3 * (10 - 15 * s + 6 * s**2)
    parts = [
        EventColumns.of(0.016 * np.arange(40), *np.round(random.uniform(-600, 600, (2, 1)) * way))
        for _ in range(12)
    ]
    trials = [Trial(f"u{i % 3}", str(i), clean=i % 2 == 0) for i in range(12)]
    return Recording.of(name, [*parts, parts[0].rows(0, 1)], [*trials, Trial("u0", "short")])


@pytest.fixture(scope="module")
def measured(tmp_path_factory: pytest.TempPathFactory) -> tuple[list[SetResults], dict[str, str]]:
    """A folder with a set and a file that cannot be read, scored with two predictors."""
    folder, out = tmp_path_factory.mktemp("recordings"), tmp_path_factory.mktemp("data")
    write(recording("reaches"), folder / "reaches_samples.parquet")
    (folder / "broken_samples.csv").write_text("user,trial,colour\nann,1,red\n", encoding="utf-8")
    unread = measure.measure(folder, ["hold", "linear"], out)
    return stored(out), unread


def test_every_set_is_kept_and_every_file_that_is_not_read_is_named(
    measured: tuple[list[SetResults], dict[str, str]],
) -> None:
    sets, unread = measured
    assert [one.summary.name for one in sets] == ["simulated-circle", "reaches"]
    assert list(unread) == ["broken_samples.csv"]


def test_cells_hold_the_numbers_of_the_json(measured: tuple[list[SetResults], dict[str, str]]) -> None:
    sets, _ = measured
    text = rendered("results/page.md", page.context(sets))
    one = sets[1].summary
    linear = one.predictors[1]
    low, high = linear.time_averaged.interval or (0.0, 0.0)
    of_reaches = {}
    for heading in ("Time-averaged error of all sets", "By time"):
        section = text.partition(f"\n## {heading}\n")[2].partition("\n## ")[0]
        row = next(line for line in section.splitlines() if line.startswith("| `linear`"))
        of_reaches[heading] = row.strip("| ").split(" | ")[2]
    average, moments = of_reaches.values()
    assert average == f"{linear.time_averaged.of_hold:.2f} [{low:.2f}, {high:.2f}]"
    assert moments.split(" / ")[1] == f"{linear.by_time[0.5].of_hold:.2f}"
    described = next(line for line in text.splitlines() if line.startswith("| [reaches]")).split(" | ")
    assert described[2:5] == ["3", "12", "6"]
    assert described[5] == "one sample, expected at least two (1)"
    assert described[-1] == f"{one.predictors[0].time_averaged.px:.1f} |"
    assert text.count("![") == 2  # the error by time of two sets


def test_what_is_kept_is_read_again(
    measured: tuple[list[SetResults], dict[str, str]], tmp_path: Path
) -> None:
    data.write(measured[0][1], tmp_path / "one.json")
    again = data.read(tmp_path / "one.json", SetResults)
    assert again == measured[0][1]  # what has been rounded once stays as it is


def cell(share: float, high: float | None = None) -> Measure:
    return Measure(100.0 * share, share, 1.0 - share, None if high is None else (0.5, high))


def predictor(name: str, share: float, *, high: float = 2.0, worst: float | None = None) -> PredictorSummary:
    later = {0.9: cell(worst)} if worst is not None else {}
    return PredictorSummary(
        name, False, 1.0, 1.0, (), cell(share, high), {0.2: cell(share + 0.01), **later}, {}, {}, None, None,
        None, {}, {},
    )  # fmt: skip


def one_set(
    name: str, users: int, *more: PredictorSummary, simulated: bool = False, **shares: float
) -> SetResults:
    described = stored()[0].summary
    predictors = (*(predictor(key, share) for key, share in {"hold": 1.0, **shares}.items()), *more)
    changed: SetSummary = msgspec.structs.replace(
        described, name=name, users=users, trials=9, simulated=simulated, predictors=predictors
    )
    return SetResults({}, changed)


def test_what_the_sets_say_together_follows_from_their_numbers() -> None:
    together = page.overall(
        [
            one_set("made", 10, simulated=True, kalman=0.5, linear=0.4, switched=0.9),
            one_set("crowd", 8, kalman=0.81, linear=1.2, switched=0.95),
            one_set("loner", 1, kalman=0.9, linear=0.84, switched=0.97),
            one_set("other", 2, kalman=0.7, linear=1.0, switched=0.8),
        ]
    )
    assert together.steady == ["kalman", "switched"]
    assert (together.worse, together.predictors) == (1, 3)
    assert (together.worse_recorded, together.recorded) == (1, 3)
    assert together.lowest == (0.7, 0.84)
    assert together.wins == [("kalman", 2), ("linear", 1)]
    assert together.alone == ["loner"]
    cautious = together.cautious
    assert (cautious.name, cautious.horizon_s) == ("kalman", 0.025)
    assert cautious.early == pytest.approx((0.71, 0.91))


def test_a_winner_that_looks_at_the_movement_is_not_called_cautious() -> None:
    assert page.overall([one_set("crowd", 8, kalman=0.9, switched=0.8)]).cautious is None
    with pytest.raises(ParameterError) as refused:
        page.overall([one_set("made", 10, simulated=True, kalman=0.5)])
    assert refused.value.code == "missing"


def test_what_has_learned_is_judged_without_the_set() -> None:
    crowd = one_set(
        "crowd", 8,
        predictor("kinematic (set left out)", 0.7, high=0.8, worst=0.97),
        predictor("kinematic (people left out)", 0.6, high=0.7, worst=0.9),
        kalman=0.9,
    )  # fmt: skip
    other = one_set("other", 8, predictor("kinematic (set left out)", 0.95, high=1.1, worst=0.9), kalman=0.8)
    together = page.overall([one_set("made", 10, simulated=True, kalman=0.9, kinematic=0.5), crowd, other])
    assert together.steady == ["kalman", "kinematic"]
    without_set, without_person = together.learned
    assert (without_set.low, without_set.high, without_set.below, without_set.sets) == (0.7, 0.95, 1, 2)
    assert (without_set.worst, without_set.worst_set, without_set.worst_time) == (0.97, "crowd", 0.9)
    assert (without_person.without, without_person.low) == ("person", 0.6)
    assert together.lowest == (0.7, 0.8)  # not the 0.60 of people left out


def test_an_unknown_error_is_left_out_and_is_not_the_best() -> None:
    unknown = Measure(None, None, None, None)
    learner = predictor("kinematic (set left out)", 0.7, high=0.8)
    early = msgspec.structs.replace(predictor("kalman", 0.6), by_time={0.2: unknown})
    crowd = one_set("crowd", 8, learner, kalman=0.6)
    blind = msgspec.structs.replace(learner, time_averaged=unknown, by_time={0.2: unknown})
    other = one_set("other", 8, blind, early)
    together = page.overall([crowd, other])
    (without_set,) = together.learned
    assert (without_set.low, without_set.worst_set) == (0.7, "crowd")
    assert together.cautious.early == pytest.approx((0.61, 0.61))
    assert page.overall([one_set("other", 8, blind, early)]).learned == []
