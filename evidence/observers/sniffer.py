"""The table of example 7 of the thesis on real data: ``python -m evidence observers sniffer``.

Needs sniffer.csv in the folder that POINTPRED_RECORDINGS names.
"""

from __future__ import annotations

import numpy as np

from evidence.arguments import parse
from evidence.data import Table, keep
from evidence.sets import folder_with
from pointpred.records import FloatArray
from pointpred_observers.reproduction.thesis import PREDICTORS, SNIFFER, estimates, sniffer


def recursion(rows: FloatArray, outputs: FloatArray, total: FloatArray, x: FloatArray) -> FloatArray:
    """(3.62) as printed, from a matrix that stands for the samples before."""
    for row, output in zip(rows, outputs, strict=True):
        total = total + np.outer(row, row)
        x = x + np.linalg.solve(total, row) * (output - row @ x)
    return x


def starts(rows: FloatArray, outputs: FloatArray) -> Table:
    """What each start makes of the data, as a table."""
    listed = {
        "ordinary least squares (LAPACK)": np.linalg.lstsq(rows, outputs, rcond=None)[0],
        "recursive, exact start": estimates(rows, outputs, 0.0)[-1],
        "recursive, ridge 0.01": estimates(rows, outputs, 0.01)[-1],
        "recursive, ridge 1": estimates(rows, outputs, 1.0)[-1],
        "as printed, begun from zero at the fourth sample": recursion(
            rows[3:], outputs[3:], rows[:3].T @ rows[:3], np.zeros(4)
        ),
    }
    return Table.of(("start", *PREDICTORS), [(name, *(f"{v:.4f}" for v in x)) for name, x in listed.items()])


def main() -> None:
    """Fill in the table where the data are at hand."""
    data = sniffer(folder_with(SNIFFER))
    if data is None:
        print("without sniffer.csv the table of example 7 stays as it is")
    else:
        keep("observers", {"sniffer": starts(*data)}, part="sniffer")


if __name__ == "__main__":
    parse(__doc__)
    main()
