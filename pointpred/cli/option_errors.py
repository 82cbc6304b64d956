"""What is wrong with the value of an option, in plain words in place of a library's."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

BOUNDS = {
    "greater_than_equal": "must be at least {ge:g}",
    "less_than_equal": "must be at most {le:g}",
    "greater_than": "must be above {gt:g}",
    "less_than": "must be below {lt:g}",
    "int_parsing": "must be a whole number",
    "int_from_float": "must be a whole number",
    "float_parsing": "must be a number",
    "finite_number": "must be a finite number",
    "bool_parsing": "must be true or false",
    "literal_error": "must be {expected}",
    "string_too_short": "must have at least {min_length} characters",
}
"""By pydantic's type of an error: what was expected, with the details that come with it."""


def option_error(name: str, problem: Mapping[str, Any]) -> str:
    """A sentence on the option ``name``, from one entry of a ``ValidationError``'s ``errors()``.

    >>> option_error("--threads", {"type": "greater_than_equal", "ctx": {"ge": 1}, "input": "0"})
    "--threads must be at least 1, received '0'"
    """
    if problem["type"] == "value_error":  # our own words
        return f"{name}: {problem['ctx']['error']}"
    words = BOUNDS.get(problem["type"], "is refused: {msg}")
    received = "" if "token" in name else f", received {problem['input']!r}"
    return f"{name} {words.format(msg=problem.get('msg'), **problem.get('ctx', {}))}{received}"


def bad_value(error: BaseException, name: str, message: str) -> str:
    """The same for an error of the command line, whose cause may be a ``ValidationError``."""
    problems = getattr(error.__cause__, "errors", None)
    return option_error(name, problems()[0]) if problems is not None else f"{name}: {message}"
