"""What the pages say of the numbers follows from the numbers."""

from pathlib import Path
from typing import Any

import pytest

from benchmarks.results_verdict import recorded, verdict
from pointpred.errors import ParameterError


def one_set(name: str, users: int, simulated: bool = False, **shares: float) -> dict[str, Any]:
    predictors = [
        {"name": key, "time_averaged": {"of_hold": share}, "by_time": {"0.2": {"of_hold": share + 0.01}}}
        for key, share in {"hold": 1.0, **shares}.items()
    ]
    return {"name": name, "users": users, "trials": 9, "simulated": simulated, "predictors": predictors}


def test_words_follow_the_numbers() -> None:
    (said,) = verdict(
        [
            one_set("made", 10, True, kalman=0.5, linear=0.4, switched=0.9),
            one_set("crowd", 8, kalman=0.81, linear=1.2, switched=0.95),
            one_set("loner", 1, kalman=0.9, linear=0.84, switched=0.97),
            one_set("other", 2, kalman=0.7, linear=1.0, switched=0.8),
        ]
    )
    assert "Below 1 on each of the 4 sets: `kalman`, `switched`; 1 of 3 predictors do worse" in said
    assert "is 0.70 to 0.84 of hold's" in said
    assert "`kalman` (2), `linear` (1)" in said
    assert "`kalman` predicts where the cursor will be 25 ms later" in said
    assert "At 20% of the time it has 0.71 to 0.91 of hold's error on these sets" in said
    assert said.endswith("sets of one person: loner.")


def test_a_winner_without_a_fixed_horizon_is_not_called_cautious() -> None:
    (said,) = verdict([one_set("crowd", 8, kalman=0.9, switched=0.8)])
    assert "`switched` (1)" in said
    assert "risks little" not in said
    assert verdict([]) == []


PAGE = """# Results

## Time-averaged error of all sets

Words.

| predictor | made (simulated) | crowd | loner |
| --- | --- | --- | --- |
| `hold` | 1.00 | 1.00 | 1.00 |
| `linear` | 0.40 | 1.20 | 0.84 |
| `kalman` | 0.50 | 0.81 | 0.90 |

## crowd

| predictor | px | all |
| --- | --- | --- |
| `linear` | 9 | 0.1 |
"""


def test_the_readme_quotes_the_first_table(tmp_path: Path) -> None:
    page = tmp_path / "results.md"
    page.write_text(PAGE)
    said = recorded(page)
    assert "On 2 recorded sets the best predictors have 0.81 to 0.84 of hold's error" in said
    assert "1 of 2 predictors do worse than no prediction" in said
    page.write_text("# Results\n")
    with pytest.raises(ParameterError, match="no recorded set"):
        recorded(page)
