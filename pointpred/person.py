"""The floats that a stage has learned of its person, as a short string and back.

The string is ``1.`` and base64url of: 8 bytes that name the layout, the learned float64 (little-endian,
exact), 8 bytes of blake2b over all before them. The layout's name is a digest of the names, counts and bounds
of the stage's ``slots``: where one of them changes, strings of the old layout are refused instead of misread.
"""

from __future__ import annotations

import base64
import binascii
import hashlib
from functools import cache

import numpy as np

from pointpred.errors import ParameterError
from pointpred.layout import Slot
from pointpred.records import BoolArray, FloatArray, IntArray
from pointpred.stage import CompiledStage

LARGEST = 16384
"""Characters of a person, at most."""
VERSION = "1."
"""Of the string; what the numbers mean is the layout's."""
DIGEST = 8


def person_of(stage: CompiledStage) -> str:
    """The person learned by ``stage``; "" if nothing was learned or nothing can be saved."""
    if not portable(stage) or not stage.known.any():
        return ""
    return packed(stage.slots, stage.known)


def restore(stage: CompiledStage, person: str) -> None:
    """Load a person into a stage without memory; "" leaves it as it is.

    Raises ParameterError for an invalid or damaged string, one of another layout, or one with an impossible
    number; the stage is then unchanged.
    """
    if not isinstance(person, str):
        raise ParameterError(
            f"person must be a string made by a pipeline, received {type(person).__name__}", field="person"
        )
    if not person:
        return
    if not portable(stage):
        raise ParameterError(
            f"person must be '' for a predictor that saves nothing of a person, "
            f"received {len(person)} characters",
            field="person",
        )
    known = unpacked(stage.slots, person)
    if objection := _bounds(stage.slots, known) or type(stage).doubt(known):
        raise ParameterError(f"person contains an impossible value: {objection}", field="person")
    stage.known[:] = known


def portable(stage: CompiledStage) -> bool:
    """Whether the learned floats of a stage can be saved."""
    return bool(stage.slots) and stage.learned > 0


def packed(slots: tuple[Slot, ...], known: FloatArray) -> str:
    """Learned floats as a string."""
    body = layout_name(slots) + known.astype("<f8").tobytes()
    return VERSION + base64.urlsafe_b64encode(body + _digest(body)).decode().rstrip("=")


def unpacked(slots: tuple[Slot, ...], person: str) -> FloatArray:
    """The learned floats of a string, not yet compared with their bounds; raises ParameterError."""
    if len(person) > LARGEST:
        raise ParameterError(f"person may have {LARGEST} characters, received {len(person)}", field="person")
    written = person.removeprefix(VERSION)
    if written == person:
        raise ParameterError(f"person must begin with {VERSION!r}, as pipelines write it", field="person")
    try:
        body = base64.b64decode(written + "=" * (-len(written) % 4), b"-_", validate=True)
    except (binascii.Error, ValueError):
        raise ParameterError(
            "person must be base64url after its version, as pipelines write it", field="person"
        ) from None
    count = sum(slot.count for slot in slots)
    if len(body) >= 2 * DIGEST and body[:DIGEST] != layout_name(slots):
        raise ParameterError(
            "person was saved by another predictor or by another version of this one", field="person"
        )
    whole = len(body) == 8 * count + 2 * DIGEST
    known = np.frombuffer(body[DIGEST:-DIGEST], "<f8").astype(np.float64) if whole else np.empty(0)
    if packed(slots, known) != person or not known.any():  # the digest is compared with all else
        raise ParameterError(
            "person is damaged: it must be the whole string, as a pipeline wrote it", field="person"
        )
    return known


@cache
def layout_name(slots: tuple[Slot, ...]) -> bytes:
    """The name of a layout."""
    return _digest(repr(slots).encode())


def _digest(body: bytes) -> bytes:
    return hashlib.blake2b(body, digest_size=DIGEST).digest()


def _bounds(slots: tuple[Slot, ...], known: FloatArray) -> str:
    """The first number that is not within the bounds of its slot, in words; empty where there is none."""
    low, high, whole, slot_of = _each_bound(slots)
    inside = (known >= low) & (known <= high)
    wrong = ~inside | (whole & (known != np.floor(known)))
    if not wrong.any():
        return ""
    place = int(wrong.argmax())
    slot, value = slots[slot_of[place]], known[place]
    if inside[place]:
        return f"{slot.name} must be whole, is {value:g}"
    return f"{slot.name} must lie in [{slot.low:g}, {slot.high:g}], is {value:g}"


@cache
def _each_bound(slots: tuple[Slot, ...]) -> tuple[FloatArray, FloatArray, BoolArray, IntArray]:
    """Of each number: the lowest and highest value, whether it is whole, and the place of its slot."""
    slot_of = np.repeat(np.arange(len(slots)), [slot.count for slot in slots])
    low, high = (np.array([[slot.low, slot.high] for slot in slots])[slot_of]).T
    return low, high, np.array([slot.whole for slot in slots])[slot_of], slot_of
