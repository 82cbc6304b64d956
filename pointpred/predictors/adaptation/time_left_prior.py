"""Everybody's weights of the time left, fitted by ``python -m evidence person time_left``."""

from __future__ import annotations

import numpy as np

from pointpred.records import FloatArray

# Fitted to 6,061 movements, each set counting as much as another, with predictions of coefficients
# that did not know the person:
# freihaut2021, pvplib23714, cryslacks, kh2017, humanmovemouse, gofitts_demo, jrcalgo.
PRIOR: FloatArray = np.array(
    (
        *(0.463, 0.05, 0.135, 0.352, -0.144, -0.102, 0.026),
        *(5.386,),
        *(4.699, 7.62),
        *(7.876, 8.315, 18.215),
        *(3.974, 3.859, 5.877, 4.439),
        *(3.135, 4.623, 4.769, 3.006, 4.42),
        *(0.488, 0.501, 1.748, 0.157, 0.026, 0.716),
        *(0.764, 0.903, 3.059, 0.155, 0.112, 0.72, 1.826),
    )
)
"""The weights of the terms; then the sums of products of two movements, the lower triangle row after row."""
