"""What the AsyncAPI document shows: one session, each message as it goes over the wire."""

from __future__ import annotations

from msgspec import Struct

from pointpred.protocol.client_messages import (
    Assist,
    Bye,
    Configure,
    Device,
    Enter,
    Events,
    Forget,
    Goal,
    Hello,
    Person,
    Reset,
    Screen,
    Target,
    Targets,
    TrialMark,
)
from pointpred.protocol.server_messages import (
    Choice,
    Cursor,
    ErrorMessage,
    KnownPerson,
    Likely,
    Limits,
    PlaceSquare,
    PredictionMessage,
    Region,
    Score,
    TargetsTaken,
    Welcome,
)
from pointpred.registry import RECOMMENDED

PERSON = "1.AvcZJo2qP2MdoSQMBXCMPw"
"""How a person begins; a whole one has some 1,700 characters and changes with the law."""

NONE = float("nan")
HELLO = Hello(
    1,
    RECOMMENDED,
    device=Device(cpi=800.0, rate_hz=1000.0),
    screen=Screen(width_px=1920.0, height_px=1080.0, dpi=96.0),
    reply="frame",
    encoding="json",
)
MESSAGES: dict[str, tuple[Struct, ...]] = {
    "hello": (
        HELLO,
        Hello(1, "hold", reply="event", encoding="binary"),
        Hello(1, RECOMMENDED, device=Device(cpi=800.0), assist=Assist(0.4, 6.0, "constant", 3.0)),
        Hello(1, RECOMMENDED, person=PERSON, places=True),
    ),
    "events": (Events([(0.5, 640.0, 360.0, None, None, 0), (0.508, 643.0, 359.0, 4.0, -1.0, 0)]),),
    "targets": (Targets([Target("save", 900.0, 20.0, 80.0, 24.0, weight=2.0)]), Targets([])),
    "trial": (TrialMark("start", Goal(940.0, 32.0, 24.0)), TrialMark("end")),
    "configure": (
        Configure(predictor="kalman"),
        Configure(reply="event"),
        Configure(assist=Assist(0.25, function="sigmoid")),
        Configure(places=True),
    ),
    "enter": (Enter("editor", 300.0, 100.0), Enter("")),
    "forget": (Forget(),),
    "reset": (Reset(),),
    "person": (Person(), Person(PERSON), Person("")),
    "bye": (Bye("done"),),
    "welcome": (Welcome(1, "k3x9Qw", RECOMMENDED, Limits()),),
    "prediction": (
        PredictionMessage(0.508, 871.5, 251.0, Region(220.5, -12.0, 180.25, 4.5), "ballistic", 0.35),
        PredictionMessage(0.5),
        PredictionMessage(0.508, 871.5, 251.0, None, "ballistic", 0.35, [Likely("save", 0.8125)]),
    ),
    "cursor": (Cursor(0.508, 652.0, 356.0, 4.0),),
    "choice": (
        Choice("save", 0.8125, "propose", 0.508, "predicted"),
        Choice("save", 0.25, "retract", 0.75),
        Choice("print", 0.375, "propose", 0.758, "entered"),
        Choice("place 7", 0.625, "propose", 0.508, "predicted", PlaceSquare(871.0, 248.0, 32.0)),
    ),
    "targetsTaken": (TargetsTaken(1),),
    "knownPerson": (KnownPerson(PERSON), KnownPerson("")),
    "score": (
        Score(
            182, 41.5, 120.25, 0.655, {"0.5": 60.0}, {"0.5": 72.5}, None, 1, hit=True, wasted=0, lead_s=0.31
        ),
        Score(90, 55.0, 110.0, 0.5, fired=2, hit=False, wasted=2),
        Score(1, reason="one sample, expected at least two"),
    ),
    "error": (
        ErrorMessage("bad_field", "Expected `float`, got `str`", "$.events[0][0]"),
        ErrorMessage(
            "bad_field",
            "degree must lie in [2, 4], received 9",
            "$.parameters.degree",
            field="degree",
            value=9,
        ),
        ErrorMessage("idle", "expected 'hello' within 10 s", recoverable=False),
        ErrorMessage(
            "slow", "the service is behind: what is sent waits for 0.12 s before it is used", behind_s=0.12
        ),
    ),
    "goodbye": (Bye("the server stops"),),
}
"""The examples of each message by its key in the document."""

EVENT_ROWS = [(0.5, 640.0, 360.0, -32768, -32768, 0), (0.508, 643.0, 359.0, 4, -1, 1)]
PREDICTION_ROW = (0.508, 871.5, 251.0, 220.5, -12.0, 180.25, 0.35, 1.0, 4.5, NONE)
"""A row of ``PredictionColumns``."""
NO_PREDICTION_ROW = (0.5, *(NONE,) * 6, 0.0, NONE, NONE)
