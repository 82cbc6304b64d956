"""Everybody's weights of the time left, fitted by ``python -m evidence person time_left``."""

from __future__ import annotations

import numpy as np

from pointpred.records import FloatArray

# Fitted to 12,126 movements, each set counting as much as another, with predictions of coefficients
# that did not know the person:
# freihaut2021, pvplib23714, cryslacks, kh2017, humanmovemouse, gofitts_demo, jrcalgo.
PRIOR: FloatArray = np.array(
    (
        *(0.103, 0.34, 0.22, 0.053, 0.162, -0.237, -0.169),
        *(5.079,),
        *(7.222, 18.259),
        *(4.412, 8.719, 6.744),
        *(3.098, 6.017, 3.963, 3.812),
        *(2.215, 3.098, 2.193, 1.859, 1.519),
        *(2.487, 7.489, 2.794, 1.202, 0.476, 6.189),
        *(0.939, 2.131, 0.914, 0.972, 0.469, 0.68, 0.577),
    )
)
"""The weights of the terms; then the sums of products of two movements, the lower triangle row after row."""
