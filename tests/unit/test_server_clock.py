"""The service takes the clock of a browser, Date.now() / 1000."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred.protocol.decoding import check_numbers, decode_client_message
from pointpred.protocol.errors import ProtocolError

NOW_S = 1.7e9


def test_the_service_takes_seconds_since_1970_and_refuses_milliseconds() -> None:
    message = f'{{"type":"events","events":[[{NOW_S + 0.5!r},1,2,null,null,0]]}}'
    assert decode_client_message(message).events[0][0] == NOW_S + 0.5
    with pytest.raises(ProtocolError) as refused:
        decode_client_message(message.replace("1700000000.5", "1700000000500"))
    assert refused.value.answer.path == "$.events[0][0]"
    row = np.array([[NOW_S, 1.0, 2.0, np.nan, np.nan, 0.0]])
    check_numbers(row)
    with pytest.raises(ProtocolError, match=r"t must lie in \[-1e\+11, 1e\+11\]"):
        check_numbers(row * 1000.0)
