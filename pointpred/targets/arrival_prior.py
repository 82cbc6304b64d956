"""Everybody's weights of the time left, fitted by ``python -m evidence person time_left``."""

from __future__ import annotations

import numpy as np

from pointpred.records import FloatArray

# Fitted to 12,126 movements, each set counting as much as another, with predictions of coefficients
# that did not know the person:
# freihaut2021, pvplib23714, cryslacks, kh2017, humanmovemouse, gofitts_demo, jrcalgo.
PRIOR: FloatArray = np.array(
    (
        *(0.072, 0.305, 0.301, 0.137, 0.089, -0.206, -0.119),
        *(5.845,),
        *(7.729, 18.181),
        *(4.578, 8.286, 6.308),
        *(3.336, 5.994, 3.822, 3.768),
        *(2.557, 3.336, 2.304, 2.005, 1.755),
        *(2.632, 7.419, 2.549, 1.194, 0.507, 6.122),
        *(1.075, 2.269, 0.921, 1.039, 0.542, 0.716, 0.66),
    )
)
"""The weights of the terms; then the sums of products of two movements, the lower triangle row after row."""
