"""How a parser refuses: with a sentence."""

from __future__ import annotations


def refused(error: Exception, naming: str = "") -> str:
    """What came of an input; raises AssertionError where the error has no sentence or does not name it."""
    sentence = str(error)
    assert sentence, "an error without a sentence"
    assert naming in sentence, f"{sentence!r} does not name {naming}"
    return "refused"
