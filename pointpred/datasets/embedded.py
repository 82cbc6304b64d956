"""The embedded sample: simulated people on the ISO circle, for the first command and for tests."""

from __future__ import annotations

from pathlib import Path

from pointpred.recording import Recording

SEED = 411
PEOPLE, TRIALS = 10, 3
NAME = "simulated-circle"
FILE = Path(__file__).with_name("simulated_circle_samples.parquet")


def generate() -> Recording:
    """Simulate the sample anew: 10 people x 8 conditions x 3 movements, the same every time.

    Takes half a second. Labelled as simulated in its name and its provenance.
    """
    from pointpred.simulation.circle import THESIS_CONDITIONS, simulate_circle
    from pointpred.simulation.person import people

    return simulate_circle(people(PEOPLE, SEED), THESIS_CONDITIONS, seed=SEED, trials=TRIALS, name=NAME)


def write() -> tuple[Path, Path]:
    """Write the sample into this package; the same library versions write the same bytes."""
    from pointpred.recordings.writing import write as write_files

    return write_files(generate(), FILE)


def sample() -> Recording:
    """The embedded sample: generated, no person was recorded.

    240 movements of 10 simulated people between novice and expert: distances 150 and 75 mm, widths 7 and
    2 mm, a sigmoid and a constant transfer function, at 1 kHz and 2000 counts per inch.

    >>> recording = sample()
    >>> len(recording.trials), recording.provenance.simulated, recording.provenance.cpi
    (240, True, 2000.0)
    """
    from pointpred.recordings.own import read

    return read(FILE)
