"""What docs/reference/monitoring.md lists, for tests that compare it with a real service and with deploy/."""

from __future__ import annotations

import re

from evidence import ROOT

PAGE = ROOT / "docs" / "reference" / "monitoring.md"
DEPLOY = ROOT / "deploy"
PARTS = {"histogram": ("_bucket", "_sum", "_count"), "counter": ("",), "gauge": ("",)}


def listed_metrics() -> dict[str, str]:
    """Kinds by the name of the metric."""
    rows = re.findall(r"^\| `([a-z_]+)` \| (\w+) \|", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
    return {name: kind for name, kind in rows if kind in PARTS}


def listed_samples() -> set[str]:
    """The names that a query may use."""
    return {name + part for name, kind in listed_metrics().items() for part in PARTS[kind]}


def listed_fields() -> set[str]:
    """The fields of log entries."""
    entries = PAGE.read_text(encoding="utf-8").partition("## Log entries")[2]
    return set(re.findall(r"^\| `([a-z_]+)` \|", entries, re.MULTILINE))


def names_in(query: str) -> set[str]:
    """The metrics that a query names."""
    return set(re.findall(r"\b(?:pointpred|process|python)_[a-z_]+", query))
