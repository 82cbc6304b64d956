"""The compiled laws of regressors and reduced-order observers equal plain Python."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np

SCRIPT = """
import sys
import numpy as np
import pointpred.compiled
from pointpred_observers import GradientRegressor, NonlinearRegressor, invariant_observer
from pointpred_observers.examples import UNMEASURED, two_masses

def answers(seed):
    random = np.random.default_rng(seed)
    t, begin = np.cumsum(random.uniform(0.001, 0.03, 60)), np.arange(60) == 41
    d, y = random.standard_normal((60, 2)), random.standard_normal(60)
    observer = invariant_observer(two_masses(), UNMEASURED, [[-1, 0], [0, 0.5]])
    both = np.column_stack([t, d, y])
    weight = np.minimum(y**2, 1.0)
    return {
        "gradient": GradientRegressor(2, gain=[[2.0, 0.5], [0.5, 1.0]]).walk(begin, both),
        "discrete": GradientRegressor(2, gain=0.3, time="discrete", normalised=True).walk(begin, both),
        "nonlinear": NonlinearRegressor(2, gain=9.0).walk(begin, np.column_stack([both, weight])),
        "observer": observer.stage().walk(begin, np.column_stack([t, d, d[::-1]])),
    }

if __name__ == "__main__":
    assert not pointpred.compiled.COMPILED
    np.savez(sys.argv[1], **answers(3))
"""


def test_compiled_agrees_with_plain_python(tmp_path: Path) -> None:
    here: dict[str, object] = {"__name__": "compiled"}
    exec(SCRIPT, here)
    file = tmp_path / "answers.npz"
    environment = {**os.environ, "POINTPRED_COMPILED": "0", "PYTHONWARNINGS": "error"}
    root = Path(__file__).parents[2]
    subprocess.run([sys.executable, "-c", SCRIPT, str(file)], check=True, env=environment, cwd=root)
    with np.load(file) as plain:
        compiled = here["answers"](3)  # type: ignore[operator]
        assert set(plain) == set(compiled)
        for name, table in compiled.items():
            np.testing.assert_allclose(table, plain[name], rtol=1e-9, atol=1e-11, err_msg=name)
