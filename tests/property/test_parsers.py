"""Every parser of what others wrote: the corpora of the fuzzer again, and damaged seeds.

``tests/fuzz/targets.py`` lists the parsers and what each promises. ``test_sources_fuzz.py`` damages more
files of recordings.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.fuzz.corpus import ARCHIVE, KEPT_BYTES, corpora, corpus, smallest, write_corpora
from tests.fuzz.targets import TARGETS
from tests.property.damage import damaged, edits


@cache
def seeds(name: str) -> list[bytes]:
    return TARGETS[name].seeds()


@pytest.mark.parametrize("name", TARGETS)
def test_the_corpus_and_the_seeds_are_read_or_refused(name: str) -> None:
    check = TARGETS[name].check
    came = {check(data) for data in [*seeds(name), *corpus(name)]}
    assert came - {"refused", "another format"}, "some are read"


@pytest.mark.parametrize("name", [name for name in TARGETS if not name.startswith("source-")])
@settings(max_examples=40)
@given(data=st.data())
def test_damaged_seeds_and_any_bytes_are_read_or_refused(name: str, data: st.DataObject) -> None:
    given_bytes = data.draw(
        st.one_of(st.builds(damaged, st.sampled_from(seeds(name)), edits()), st.binary(max_size=200))
    )
    TARGETS[name].check(given_bytes)


def test_every_corpus_is_of_a_target_and_small() -> None:
    assert corpora().keys() <= TARGETS.keys()
    assert sum(map(len, corpora().values())) > 1400
    for inputs in corpora().values():
        assert sum(map(len, inputs)) <= KEPT_BYTES


def test_the_same_corpora_make_the_same_archive(tmp_path: Path) -> None:
    again = tmp_path / "corpus.tar.xz"
    write_corpora({name: inputs[::-1] for name, inputs in reversed(corpora().items())}, again)
    assert again.read_bytes() == ARCHIVE.read_bytes()


def test_the_smallest_inputs_are_kept() -> None:
    assert smallest([b"abc", b"", bytes(KEPT_BYTES), b"b", b"a"]) == [b"", b"a", b"b", b"abc"]
