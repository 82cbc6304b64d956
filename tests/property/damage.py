"""Damaged bytes: cuts, insertions, replacements and repetitions of what readers stumble over."""

from __future__ import annotations

from hypothesis import strategies as st

Edits = list[tuple[str, float, int, bytes]]
SPICE = (
    b"\0",
    b"\xff",
    b"\n",
    b'"',
    b"[",
    b"}",
    b",",
    b": ",
    b"-",
    b"nan",
    b"1e999",
    b"9" * 25,
    b"\xed\xa0\x80",
    b"null",
)


def edits(least: int = 0) -> st.SearchStrategy[Edits]:
    """At least so many edits, and at most four."""
    return st.lists(
        st.tuples(
            st.sampled_from(["cut", "insert", "replace", "drop", "repeat"]),
            st.floats(0, 1, exclude_max=True),
            st.integers(1, 40),
            st.one_of(st.sampled_from(SPICE), st.binary(max_size=4)),
        ),
        min_size=least,
        max_size=4,
    )


def damaged(data: bytes, changes: Edits) -> bytes:
    """The bytes after the edits."""
    for what, where, length, new in changes:
        at = int(where * len(data))
        before, after = data[:at], data[at:]
        data = {
            "cut": before,
            "insert": before + new + after,
            "replace": before + new + after[len(new) :],
            "drop": before + after[length:],
            "repeat": data[: at + length] + after,
        }[what]
    return data
