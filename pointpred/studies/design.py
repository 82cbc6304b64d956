"""The design of a study: a TOML file, read and checked, and a commented one to start from."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Annotated, Any, Literal, get_args, get_type_hints

import msgspec
from msgspec import Meta, Struct

from pointpred.errors import ParameterError

Task = Literal["circle", "reciprocal"]
Name = Annotated[str, Meta(pattern=r"^[A-Za-z][A-Za-z0-9_-]{0,39}\Z")]
Words = Annotated[str, Meta(min_length=1, max_length=20_000)]
Px = Annotated[float, Meta(ge=1.0, le=10_000.0)]
Unknown = re.compile(r"contains unknown field `(.*?)`")

MOST_MOVEMENTS = 20_000
"""Of a participant: more take a day without sleep."""

TEMPLATE = '''\
# A study of pointing. Change what you need, then:
#   pointpred study serve {file}     prints a link for each participant
#   pointpred study status {file}    how far everybody is
#   pointpred study export {file}    one recording of all participants, for pointpred score
# Once somebody has taken part, only `participants` may still change.

name = "{name}"        # of the recordings: letters, digits, - and _
participants = 12        # P01 to P12, a link each

# What participants read. Nothing is stored before they agree to the consent text.
title = "A study of pointing"
consent = """
You take part in a study of how people point with a mouse. We record the movements of your pointer, your
answers, and what your browser tells about your screen and device. You can stop at any time.
"""
instructions = """
Click the filled target, then the next one, as fast as you can without missing.
"""
thanks = "That was all. Thank you! You can close this page."

# The conditions: every task with every distance and every width, in px of the page.
tasks = ["circle"]       # "circle": ISO 9241-411, 2-D; "reciprocal": two bars in turn, 1-D
distances_px = [200, 400]
widths_px = [20, 40]
movements = 13           # in each sequence; on a circle also its number of targets, which is odd
bar_height_px = 240      # of the bars of "reciprocal"

# Each block holds a sequence of every condition. Blocks of practice come first, marked phase = practice.
blocks = 2
practice_blocks = 0
order = "latin-square"   # of the conditions: "latin-square" by participant, "random", or "as-written"
seed = 1                 # of "random": the same seed gives the same orders
break_s = 20             # the shortest break after each block; 0: no break
on_error = "go-on"       # at a click beside the target: "go-on", "repeat" the movement, or "until-inside"

# Questions, asked "before" or "after" the task. An answer is one of `choices`, a number, or text.
[[questions]]
name = "hand"
text = "With which hand do you use the mouse?"
when = "before"
choices = ["left", "right"]

[[questions]]
name = "effort"
text = "How hard was it, from 0 (not at all) to 100 (very)?"
kind = "number"
low = 0
high = 100

[[questions]]
name = "remarks"
text = "Anything else?"
required = false
'''
"""What ``pointpred study new`` writes."""


class Question(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """One question; the answer is one of ``choices`` where there are some, else of its ``kind``."""

    name: Name
    text: Words
    when: Literal["before", "after"] = "after"
    kind: Literal["text", "number"] = "text"
    choices: list[Annotated[str, Meta(min_length=1, max_length=200)]] = []
    low: float | None = None
    high: float | None = None
    required: bool = True

    def check(self) -> None:
        """Raise ValueError where nobody could answer, or a field would have no effect."""
        bounded = self.low is not None or self.high is not None
        if self.choices and (self.kind == "number" or bounded):
            raise ValueError(f"questions: {self.name!r} has choices, and is no number besides")
        if bounded and self.kind != "number":
            raise ValueError(f'questions: {self.name!r} has low or high, and needs kind = "number"')
        if self.low is not None and self.high is not None and not self.low <= self.high:
            raise ValueError(f"questions: {self.name!r} has low {self.low:g} and high {self.high:g}")
        for choice in self.choices:
            if choice != choice.strip():
                raise ValueError(f"choices of {self.name!r}: {choice!r} begins or ends with a space")
        _check_once(f"choices of {self.name!r}", self.choices)

    def refuse(self, answer: str) -> str | None:
        """Why this is no answer, ``None`` where it is one; an empty one leaves the question out."""
        if not answer:
            return "it needs an answer" if self.required else None
        if self.choices:
            return None if answer in self.choices else f"expected one of {', '.join(self.choices)}"
        if self.kind == "number":
            low, high = (-1e9 if self.low is None else self.low), (1e9 if self.high is None else self.high)
            try:
                within = low <= float(answer) <= high
            except ValueError:
                within = False
            return None if within else f"expected a number from {low:g} to {high:g}"
        return None


class Design(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """What a study is; ``pointpred study new`` writes one that explains every field."""

    name: Name
    participants: Annotated[int, Meta(ge=1, le=999)]
    title: Words
    consent: Words
    instructions: Words
    thanks: Words = "Thank you. You can close this page."
    tasks: Annotated[list[Task], Meta(min_length=1)]
    distances_px: Annotated[list[Px], Meta(min_length=1, max_length=50)]
    widths_px: Annotated[list[Px], Meta(min_length=1, max_length=50)]
    movements: Annotated[int, Meta(ge=1, le=101)] = 13
    bar_height_px: Px = 240.0
    blocks: Annotated[int, Meta(ge=1, le=100)] = 1
    practice_blocks: Annotated[int, Meta(ge=0, le=100)] = 0
    order: Literal["latin-square", "random", "as-written"] = "latin-square"
    seed: Annotated[int, Meta(ge=0)] = 0
    break_s: Annotated[float, Meta(ge=0.0, le=3600.0)] = 0.0
    on_error: Literal["go-on", "repeat", "until-inside"] = "go-on"
    questions: list[Question] = []

    def __post_init__(self) -> None:
        for field in ("tasks", "distances_px", "widths_px"):
            _check_once(field, getattr(self, field))
        for field in ("title", "consent", "instructions", "thanks"):
            if not getattr(self, field).strip():
                raise ValueError(f"{field}: expected words, received only spaces")
        _check_once("questions", [question.name for question in self.questions])
        if "circle" in self.tasks and (self.movements < 3 or self.movements % 2 == 0):
            raise ValueError(
                f"movements: a circle needs an odd number from 3, so that the order across it visits every "
                f"target, received {self.movements}"
            )
        if max(self.widths_px) >= min(self.distances_px):
            raise ValueError(
                f"widths_px: every width must be below every distance, or two targets in turn overlap; "
                f"received a width of {max(self.widths_px):g} and a distance of {min(self.distances_px):g}"
            )
        conditions = len(self.tasks) * len(self.distances_px) * len(self.widths_px)
        movements = (self.blocks + self.practice_blocks) * conditions * self.movements
        if movements > MOST_MOVEMENTS:
            raise ValueError(
                f"blocks: {movements} movements of each participant, expected at most {MOST_MOVEMENTS}"
            )
        for question in self.questions:
            question.check()

    @property
    def codes(self) -> list[str]:
        """The participants: P01, P02, ...; how many there are changes none of the codes."""
        return [f"P{number:02}" for number in range(1, self.participants + 1)]


def _check_once(field: str, values: Sequence[object]) -> None:
    for value in values:
        if values.count(value) > 1:
            raise ValueError(f"{field}: {value!r} stands there twice")


def read_design(file: Path) -> Design:
    """The design in a TOML file; raises ParameterError that names the file, the field and what is wrong."""
    try:
        return design_of(file.read_text(encoding="utf-8"))
    except OSError as error:
        raise ParameterError(
            f"{file}: {error.strerror}; 'pointpred study new {file}' writes a design to start from"
        ) from error
    except ValueError as error:
        raise ParameterError(f"{file}: {error}") from error


def design_of(text: str) -> Design:
    """The design in a text; raises ValueError."""
    try:
        return msgspec.convert(tomllib.loads(text), Design)
    except msgspec.ValidationError as error:
        words, _, place = str(error).partition(" - at `$")
        field = place.strip("`.")
        where = Question if field.startswith("questions") else Design
        if (unknown := Unknown.search(words)) is not None:
            names = where.__struct_fields__
            near = get_close_matches(unknown[1], names, 1)
            advice = f"did you mean {near[0]}?" if near else f"known are {', '.join(names)}"
            words = f"there is no {unknown[1]}; {advice}"
        elif words.startswith("Invalid enum value"):
            chosen: Any = get_type_hints(where)[field.rpartition("].")[2].partition("[")[0]]
            words += f", expected one of {', '.join(get_args(get_args(chosen)[0]) or get_args(chosen))}"
        raise ValueError(f"{field}: {words}" if field else words) from None
