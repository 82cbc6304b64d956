"""Digests of what the product answers, to compare two trees: ``python evidence/house/outputs.py FILE.json``.

Predictions, motions and choices to the bit; documents of the commands by value. Uses public names and
commands only, so that it runs on trees of other layouts: set PYTHONPATH to the folders of its distributions.
``--before FILE.json`` compares and names what differs. Takes some ten minutes.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

Digest = tuple[str, str]
PREDICTORS = (
    "hold,linear,kalman,minimum-jerk,switched,switched-direction,kep-quartic-gated,ktm,kinematic,"
    "kinematic-adaptive"
)
UNTIMED = ("us_per_event", "measured")
"""Fields of a document that differ from run to run."""
PLANTS = ("motor", "pendulum", "tank", "wing", "spring", "oven", "oscillator", "heating")
DESIGNS: tuple[tuple[str, ...], ...] = (
    ("motor",),
    ("motor", "--observer", "full-order"),
    ("pendulum",),
    ("tank",),
    ("wing",),
    ("spring", "oscillator.json"),
    ("oven", "heating.json"),
)
FIGURES = ("2.5", "2.7", "2.11", "2.12", "3.3", "3.7", "3.8", "3.9", "4.2", "4.4", "camera-table-1")


def digest(*parts: object) -> str:
    return hashlib.sha256("".join(map(repr, parts)).encode()).hexdigest()[:16]


def untimed(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: untimed(one) for key, one in value.items() if key not in UNTIMED}
    return [untimed(one) for one in value] if isinstance(value, list) else value


def plain(one: Any) -> tuple[Any, ...] | None:
    return None if one is None else (one.t, one.x, one.y, one.covariance, one.phase, one.remaining_s)


def predictions(recordings: Path) -> Iterator[Digest]:
    from pointpred import REGISTRY, build, run
    from pointpred.datasets import sample
    from pointpred.differentiators import HomogeneousDifferentiator
    from pointpred.recordings import read_any

    sets = [("sample", sample())]
    sets += [(path.stem, read_any(path)[0]) for path in sorted(recordings.glob("*_samples.parquet"))]
    for name, recording in sets:
        count = len(recording.trials)
        chosen = list(range(0, count, max(1, count // 12)))[:12]
        for predictor in REGISTRY:
            for cpi in (None, 1000.0) if name == "sample" else (None,):
                whole, single = build(predictor, cpi=cpi), build(predictor, cpi=cpi)
                seen: list[Any] = []
                for k in chosen:
                    seen.append([plain(one) for one in run(whole, recording.rows(k)).predictions()])
                    whole.reset()
                events = list(recording.rows(chosen[1]).events())[:60]
                seen.append([plain(single.update(event)) for event in events])
                places = [(one.x, one.y, one.p, one.before, one.spread) for one in whole.places]
                yield f"predictions/{name}/{predictor}/{cpi}", digest(*seen, whole.person, places)
        motions = []
        stage = HomogeneousDifferentiator()
        for k in chosen[:3]:
            stage.reset()
            for event in list(recording.rows(k).events())[:80]:
                m = stage.update(event)
                motions.append((m.t, m.x, m.y, m.vx, m.vy, m.ax, m.ay, m.settled))
        yield f"motions/{name}", digest(motions)
        for other in ("difference", "kalman"):
            out = run(build("minimum-jerk", differentiator=other), recording.rows(chosen[1]))
            yield (
                f"predictions/{name}/minimum-jerk-{other}",
                digest(np.column_stack([out.t, out.x, out.y]).tolist()),
            )


def choices() -> Iterator[Digest]:
    from pointpred import build
    from pointpred.datasets import sample
    from pointpred.targets import Chooser, around

    recording = sample()
    circle = [around(f"t{k}", 960 + 300 * np.cos(k), 540 + 300 * np.sin(k), 60, 60) for k in range(12)]
    for predictor in ("kinematic", "switched", "kinematic-adaptive"):
        pipeline, seen = build(predictor), []
        for k in range(0, 40, 5):
            pipeline.register(circle)
            chooser = Chooser(pipeline)
            for event in recording.rows(k).events():
                pipeline.update(event)
                seen.append([(one.id, one.p, one.action, one.reason) for one in chooser.update()])
                seen.append(pipeline.aim.shares.tolist())
            pipeline.reset()
        yield f"choices/{predictor}", digest(seen)


def documents(folder: Path, recordings: Path, inputs: list[Path]) -> Iterator[Digest]:
    def command(*words: object) -> subprocess.CompletedProcess[str]:
        line = [sys.executable, "-m", "pointpred", *map(str, words)]
        return subprocess.run(line, cwd=folder, capture_output=True, text=True, check=False, timeout=900)

    for source in inputs:
        done = command("convert", source, "--out", "out_samples.csv", "--force")
        written = [(one.name, one.read_bytes()) for one in sorted(folder.glob("out_*"))]
        for one in folder.glob("out_*"):
            one.unlink()
        yield (
            f"convert/{source.name}",
            digest(done.returncode, done.stderr.replace(str(source.parent), ""), written),
        )
    for name in ("sample", "gofitts_demo_samples.parquet", "pvplib23714_samples.parquet"):
        scored = name if name == "sample" else recordings / name
        for more in (("--predictors", PREDICTORS), ("--predictors", "kinematic,switched", "--targets")):
            if name == "sample" or "--targets" not in more:
                done = command("score", scored, *more, "--threads", 1, "--json", "-")
                yield f"score/{name}/{len(more)}", digest(untimed(json.loads(done.stdout)))
    command("simulate", "--out", "people_samples.csv", "--seed", 3)
    yield "simulate", digest([(one.name, one.read_bytes()) for one in sorted(folder.glob("people*"))])
    yield "predictors", digest(command("predictors", "--json", "-").stdout)
    for plant in PLANTS:
        command("observers", "example", plant, "--out", f"{plant}.json")
        yield f"observers/example/{plant}", digest((folder / f"{plant}.json").read_bytes())
    for plant, *options in DESIGNS:
        file = folder / "design.json"
        file.unlink(missing_ok=True)
        done = command("observers", "design", f"{plant}.json", *options, "--out", file.name, "--json", "-")
        design = file.read_bytes() if file.exists() else b""
        yield f"observers/design/{plant}/{'-'.join(options)}", digest(done.returncode, done.stdout, design)
    command("camera", "simulate", "--focal-px", 800, "--out", "camera.csv")
    yield "camera/simulate", digest((folder / "camera.csv").read_bytes())
    done = command("camera", "run", "camera.csv", "camera_truth.csv", "--focal-px", 800, "--json", "-")
    yield "camera/run", digest(done.stdout)
    for number in FIGURES:
        done = command("reproduce", number, "--out", "figure.svg", "--force", "--json", "-")
        yield f"reproduce/{number}", digest(done.returncode, done.stdout)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", type=Path)
    parser.add_argument(
        "--recordings", type=Path, required=True, help="the folder POINTPRED_RECORDINGS names"
    )
    parser.add_argument(
        "--inputs", type=Path, nargs="*", default=[Path("tests/data/sources")], help="folders of files"
    )
    parser.add_argument("--before", type=Path, help="digests of another tree")
    given = parser.parse_args()
    inputs = [
        one for folder in given.inputs for one in sorted(folder.iterdir()) if one.suffix not in (".md", ".py")
    ]
    known: dict[str, str] = {}
    with tempfile.TemporaryDirectory() as folder:
        parts = (predictions(given.recordings), choices(), documents(Path(folder), given.recordings, inputs))
        for part in parts:
            for name, value in part:
                known[name] = value
                print(name, value, flush=True)
    given.file.write_text(json.dumps(known, indent=1) + "\n", encoding="utf-8")
    if given.before:
        before = json.loads(given.before.read_text(encoding="utf-8"))
        differ = [name for name in sorted({*known, *before}) if known.get(name) != before.get(name)]
        print(f"{len(differ)} of {len(known)} differ:", *differ, sep="\n  ")


if __name__ == "__main__":
    main()
