"""Everybody's weights of the time left, fitted by ``python -m pages.adaptation.fit``."""

from __future__ import annotations

# Fitted to 6,061 movements, each set counting as much as another, with predictions of coefficients
# that did not know the person:
# freihaut2021, pvplib23714, cryslacks, kh2017, humanmovemouse, gofitts_demo, jrcalgo.
PRIOR = (
    *(0.486, 0.078, 0.114, 0.346, -0.16, -0.101, 0.044),
    *(5.294,),
    *(4.64, 7.676),
    *(7.812, 8.366, 18.265),
    *(3.945, 3.887, 5.898, 4.446),
    *(3.129, 4.763, 4.83, 3.053, 4.59),
    *(0.483, 0.5, 1.751, 0.156, 0.027, 0.717),
    *(0.748, 0.898, 2.994, 0.155, 0.105, 0.71, 1.753),
)
"""The weights of the terms; then the sums of products of two movements, the lower triangle row after row."""
