"""The coefficients of the learned predictor as a module of the page: a text that is unpacked there."""

from __future__ import annotations

import numpy as np

from pointpred.predictors.kinematic.coefficient_file import MANTISSA_BITS
from pointpred.records import FloatArray

DIGITS = np.array(list("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_"))
DIGIT_BITS = 6


def coefficients_text(coefficients: FloatArray) -> str:
    """The module that exports these numbers; raises ValueError for numbers that three digits cannot tell.

    A digit of sign and exponent, one of the mantissa's upper bits, one of its lower bits; first this digit
    of all numbers, then the next, because the text compresses better so: 15.5 kB of 24.
    """
    fraction, exponent = np.frexp(np.abs(coefficients))
    mantissa = (2.0 * fraction - 1.0) * 2.0**MANTISSA_BITS
    exponent -= 1
    lowest = int(exponent.min())
    first = 2 * (exponent - lowest) + np.signbit(coefficients)
    if (fraction == 0.0).any() or (mantissa % 1.0).any() or first.max() >= len(DIGITS):
        raise ValueError(f"coefficients must be numbers of {MANTISSA_BITS} bits, within 32 powers of two")
    upper, lower = np.divmod(mantissa.astype(int), 2 ** (MANTISSA_BITS - DIGIT_BITS))
    text = "".join(DIGITS[np.concatenate([first, upper, lower])])
    return (
        "// Written by `make laws` from kinematic.npz: train that and run it again.\n"
        'import { unpack } from "./coefficients.js";\n'
        f'export const COEFFICIENTS = /* @__PURE__ */ unpack("{text}", {lowest});\n'
    )
