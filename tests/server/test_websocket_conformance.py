"""The cases of the Autobahn suite against a real socket of the service, families 1 to 7, 9 and 10.

The sessions of this service send back what they receive, as the suite expects of every server; all below the
session is what pointing sessions run on. Families 12 and 13 do not apply: compression is off.
"""

from __future__ import annotations

import asyncio

import pytest

from tests.server import autobahn

pytest.importorskip("kosoku", reason="kosoku, which runs the Autobahn cases, is not installed")


@pytest.fixture(scope="module")
def verdicts() -> dict[str, autobahn.Verdict]:
    return asyncio.run(autobahn.run())


@pytest.mark.parametrize("family", autobahn.FAMILIES)
def test_every_case_of_a_family_ends_as_the_suite_asks(
    family: str, verdicts: dict[str, autobahn.Verdict]
) -> None:
    cases = {case: verdict for case, verdict in verdicts.items() if case.startswith(f"{family}.")}
    assert len(cases) == autobahn.FAMILIES[family]
    broken = {case: verdict for case, verdict in cases.items() if not autobahn.holds(case, verdict)}
    assert not broken
