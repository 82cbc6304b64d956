"""A record is declared once: what laws, rows and sentences say of it agrees with the declaration."""

from __future__ import annotations

from math import inf, nan, nextafter

import msgspec
import pytest

from pointpred import Motion, build
from pointpred.errors import EventError
from pointpred.predictors import HoldPredictor
from pointpred.protocol.frames import EVENT
from pointpred.records import (
    EVENT_FIELD,
    EVENT_FIELDS,
    FINE,
    MOTION_FIELDS,
    EventColumns,
    EventRow,
    MotionRow,
    fault_of_event,
)

GOOD = EventRow(1.0, 2.0, 3.0, 4.0, 5.0, 1.0)


def test_rows_and_packed_events_have_the_fields_in_their_order() -> None:
    assert EventRow._fields == tuple(field.name for field in EVENT_FIELDS) == EVENT.names
    assert MotionRow._fields == tuple(field.name for field in MOTION_FIELDS)


@pytest.mark.parametrize("place", range(len(EVENT_FIELDS)))
def test_the_law_keeps_to_the_declared_bounds(place: int) -> None:
    field = EVENT_FIELDS[place]
    for bound, beyond in ((field.low, nextafter(field.low, -inf)), (field.high, nextafter(field.high, inf))):
        within = GOOD._replace(**{field.name: bound})
        assert fault_of_event(within) == FINE
        outside = GOOD._replace(**{field.name: beyond})
        assert fault_of_event(outside) == EVENT_FIELD + place
        with pytest.raises(EventError, match=rf"^row 0: {field.name} must lie in") as refused:
            build("hold").differentiator.run(EventColumns([list(outside)]))
        assert (refused.value.field, refused.value.value) == (field.name, beyond)


@pytest.mark.parametrize("value", [nan, inf, -inf, 1e301])
@pytest.mark.parametrize("field", [field.name for field in MOTION_FIELDS[:7]])
def test_the_value_of_a_motion_that_is_wrong_is_named(field: str, value: float) -> None:
    motion = msgspec.structs.replace(Motion(1.0, 2.0, 3.0, 0.1, 0.2, 0.3, 0.4, True), **{field: value})
    with pytest.raises(EventError) as refused:
        HoldPredictor().update(motion)
    assert str(refused.value) == f"{field} must lie in [-1e+300, 1e+300], received {value!r}"
    assert refused.value.field == field
