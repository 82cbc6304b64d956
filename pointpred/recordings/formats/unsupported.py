"""Files of other programs that are not read, and how to export them as a table that is."""

from __future__ import annotations

ADVICE = (
    ((b"RDX2\n", b"RDX3\n"), "R data are not read; in R: write.csv(NAME, 'table.csv', row.names = FALSE)"),
    (
        (b"X\n\x00\x00\x00", b"A\n2\n", b"A\n3\n"),
        "R data are not read; in R: write.csv(readRDS('FILE'), 'table.csv', row.names = FALSE)",
    ),
    (
        (b"$FL2", b"$FL3"),
        "SPSS data are not read; save them in SPSS as CSV, or in R: write.csv(haven::read_sav(...), ...)",
    ),
    ((b"\x89HDF\r\n",), "HDF5 is not read; save t, x and y as CSV"),
)


def advice(head: bytes) -> str:
    """Advice for a file that begins with ``head``; empty if the format is unknown.

    >>> advice(b"$FL2")
    'SPSS data are not read; save them in SPSS as CSV, or in R: write.csv(haven::read_sav(...), ...)'
    """
    return next((words for marks, words in ADVICE if head.startswith(marks)), "")
