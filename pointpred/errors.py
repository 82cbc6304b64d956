"""Everything pointpred raises on purpose: one family, each member also the matching builtin.

A program reads ``code``, ``field`` and ``value``; the sentence is for people and may change.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence


class PointpredError(Exception):
    """The root: catch this to catch every error pointpred raises on purpose.

    ``code``: a short word that stays the same between versions; ``field``: the name of the parameter,
    column or field that is wrong, "" where it is none in particular; ``value``: what was received there.
    """

    code: str = "error"

    def __init__(self, message: str = "", *, code: str = "", field: str = "", value: object = None) -> None:
        super().__init__(message)
        if code:
            self.code = code
        self.field = field
        self.value = value


class ParameterError(PointpredError, ValueError):
    """A parameter is unknown, of the wrong kind or outside its bounds."""

    code = "bad_parameter"


class EventError(PointpredError, ValueError):
    """An event cannot be used: a value is not finite or out of range. The stage is unchanged."""

    code = "bad_event"


class EventOrderError(EventError):
    """An event lies before the one already accepted. The stage is unchanged."""

    code = "time_backwards"


class RecordingError(PointpredError, ValueError):
    """A recording cannot be read: the message names the file, the row and what was expected."""

    code = "bad_recording"


class ColumnsError(RecordingError):
    """No mapping of a table's columns is possible, or more than one.

    ``columns``: the names found; ``guess``: our field -> the column it may be; ``time_unit``: the unit of
    time as far as it is known, ``None`` where it has to be named; ``reason`` in a few words.
    """

    code = "unclear_columns"

    def __init__(
        self,
        message: str,
        columns: Sequence[str] = (),
        guess: Mapping[str, str] | None = None,
        time_unit: str | None = None,
        reason: str = "",
    ) -> None:
        super().__init__(message)
        self.columns = tuple(columns)
        self.guess = dict(guess or {})
        self.time_unit = time_unit
        self.reason = reason


class InfeasibleError(PointpredError, ArithmeticError):
    """A design problem is proved to have no solution."""

    code = "infeasible"


class UndecidedError(PointpredError, ArithmeticError):
    """A solver could neither solve a design problem nor prove it infeasible."""

    code = "undecided"


class CertificateError(PointpredError, ArithmeticError):
    """A claimed certificate fails when its eigenvalues are recomputed."""

    code = "bad_certificate"


class MissingExtraError(PointpredError, ImportError):
    """An optional library is not installed; the message holds the line that installs it."""

    code = "missing_extra"


class DivergenceError(PointpredError, ArithmeticError):
    """A simulated trajectory leaves every bound."""

    code = "divergence"


class SourceError(PointpredError, OSError):
    """A device or another live source cannot be opened or has gone."""

    code = "no_source"
