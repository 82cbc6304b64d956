"""What is said of a parameter that cannot be: its name, its bounds with their unit, and what came."""

import pytest

from pointpred.errors import ParameterError
from pointpred.parameter import Parameter, check


@pytest.mark.parametrize(
    ("unit", "value", "said"),
    [
        ("", 13, "trials must lie in [1, 12], received 13"),
        ("s", 13, "trials must lie in [1, 12] s, received 13"),
        ("", "x", "trials must be a number, received 'x'"),
        ("s", True, "trials must be a number (s), received True"),
    ],
)
def test_the_sentence_has_a_unit_only_where_there_is_one(unit: str, value: object, said: str) -> None:
    with pytest.raises(ParameterError) as error:
        check((Parameter("trials", unit, 1, 12, "how many"),), {"trials": value})
    assert str(error.value) == said
