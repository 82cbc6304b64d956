"""What is written after ``python -m evidence NAME PART`` is understood before numbers are written over."""

from __future__ import annotations

import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from evidence.arguments import parse
from evidence.costs import per_event

ROOT = Path(__file__).parents[2]
RUN = {
    path.relative_to(ROOT).with_suffix("").as_posix(): path.read_text(encoding="utf-8")
    for path in (ROOT / "evidence").rglob("*.py")
    if 'if __name__ == "__main__":' in path.read_text(encoding="utf-8")
}


@pytest.mark.parametrize("name", sorted(RUN.keys() - {"evidence/__main__"}))
def test_each_benchmark_reads_its_words_first(name: str) -> None:
    last = RUN[name].split('if __name__ == "__main__":')[1]
    assert "parse(__doc__" in last or "argparse.ArgumentParser(" in RUN[name]
    assert "sys.argv" not in RUN[name].replace("main(sys.argv[1:])", ""), "words that are read refuse others"


def test_help_and_mistakes_end_before_anything_is_done(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for told, code, where in ((["--help"], 0, "out"), (["rubbish"], 2, "err")):
        monkeypatch.setattr(sys, "argv", ["benchmark", *told])
        with pytest.raises(SystemExit) as ended:
            parse("What it measures.")
        assert ended.value.code == code
        assert ("What it measures." if code == 0 else "rubbish") in getattr(capsys.readouterr(), where)


def test_a_benchmark_understands_what_it_tells_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    """``per_event`` measures plain Python in a process of its own."""
    told: list[str] = []

    def run(command: list[str], **_: object) -> SimpleNamespace:
        told.extend(command[command.index("evidence.costs.per_event") :])
        return SimpleNamespace(stdout='{"hold": {"streaming": 1.0}}')

    monkeypatch.setattr("evidence.costs.per_event.subprocess.run", run)
    assert per_event.measure_plain() == {"hold": {"streaming": 1.0}}
    monkeypatch.setattr(per_event, "measure", lambda plain: {"plain": plain})
    monkeypatch.setattr(sys, "argv", told)
    said: list[str] = []
    monkeypatch.setattr("builtins.print", said.append)
    exec(
        RUN["evidence/costs/per_event"].split('if __name__ == "__main__":')[1].strip(), vars(per_event).copy()
    )
    assert said == ['{"plain": true}']


def test_words_that_are_meant_are_returned(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["benchmark", "one", "two"])
    assert parse("What it measures.", metavar="figure") == ["one", "two"]
    wrongs: list[dict[str, Any]] = [{"most": 1}, {"choices": ["one"]}]
    for wrong in wrongs:
        with pytest.raises(SystemExit):
            parse("What it measures.", metavar="figure", **wrong)
