"""What the AsyncAPI document says beside the message types: texts, and examples as they go over the wire.

The tests compare the lists with the code.
"""

from __future__ import annotations

from msgspec import Struct

from pointpred.protocol.client_messages import (
    SUBPROTOCOL,
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
    Rectangle,
    Reset,
    Screen,
    Targets,
    TrialMark,
)
from pointpred.protocol.server_messages import (
    ChoiceMessage,
    Cursor,
    EndpointLaw,
    ErrorMessage,
    KnownPerson,
    Likely,
    Limits,
    PlaceSquare,
    PredictionMessage,
    Score,
    TargetsTaken,
    Welcome,
)
from pointpred.registry import RECOMMENDED

ABOUT = f"""One pointing session over a WebSocket: pointer events in, predictions of the endpoint out.

The session goes connecting -> greeted -> streaming -> closed. The client speaks first, with `hello`; anything
else before it is answered by an error. Every JSON message is one object with `type` in a text frame; unknown
fields are errors. With `encoding: binary` in `hello`, events and predictions go as binary frames of packed
records instead; everything else stays JSON. Positions are px with y growing downwards, times are seconds on
the client's clock. A client that reads slowly gets the newest prediction only, and the number of those
dropped. While the service is behind, frames that have waited are answered once, and `slow` has `behind_s` at
most once a second. Proposals among targets (`choice`) go as text in either encoding; if more than 64 wait to
be read, the client gets a summary: the end of the proposal it was sent, and the current one.

With `assist` in `hello` the service moves the cursor: events carry counts, the first one has the position of
the cursor before it, and before each prediction `cursor`, as text in either encoding, has its current
position. Positions in later events are ignored. `configure` may replace `assist`, but not add it.

Subprotocol: `{SUBPROTOCOL}`. A page of another origin or a foreign `Host` is refused with HTTP 403 before the
upgrade. A token is needed where one is set; one is generated for an address that is not loopback."""
CLOSES = {
    1000: "after `bye`",
    1001: "the server stops, after its `bye`",
    1007: "a text that is not UTF-8",
    1008: "no `hello` within 10 s, nothing heard for `idle_s`, over `max_events_per_s`, no valid token",
    1009: "a frame over `max_frame_bytes` or with more than `max_events_per_frame` events",
    1011: "something failed in the server",
    1013: "more sessions than `max_sessions`, or the answers are not read",
}
CODES = {
    "bad_json": "the text is not JSON; the frame is dropped",
    "bad_field": "a field is missing, unknown, of another type or out of range; the frame is dropped",
    "unknown_type": "no message of this type; the frame is dropped",
    "unknown_predictor": "no predictor of this name; the message names the known ones",
    "out_of_order": "events before the last one were dropped, the rest of the frame was used",
    "out_of_place": "the message cannot come now; it was ignored",
    "too_large": "a frame has too many bytes or events; the session ends",
    "too_fast": "too many events or other messages a second; the session ends",
    "too_many": "too many targets (the set stays as it was) or sessions (the session ends)",
    "idle": "no hello in time, or nothing was heard; the session ends",
    "slow": "predictions or choices gave way to newer ones; with behind_s: the service is behind; "
    "not recoverable: nothing is read",
    "unauthorized": "no valid token; the session ends",
    "stopping": "the server stops; the session ends",
    "internal": "something failed in the server; the session ends",
    "columns": "the columns of an uploaded table are not certain; sent over HTTP only",
}
NEEDED = "Needed where one is set; one is generated for an address that is not loopback."
SECURITY = {
    "token": {"type": "httpApiKey", "in": "query", "name": "token", "description": NEEDED},
    "bearer": {"type": "http", "scheme": "bearer", "description": f"The same token as a header. {NEEDED}"},
}
EVENTS = (
    "Pointer events as packed little-endian records without padding, in a session with `encoding: binary`; "
    "{none} in dx or dy: no counts."
)
PREDICTIONS = (
    "Predictions as packed little-endian records without padding, one for the newest event or, with "
    "`reply: event`, one for each. NaN where a field is null; all NaN but t, and phase 0, where there is "
    "no prediction. Phases: {phases}. A region with tail NaN is that of a normal law."
)

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
    "targets": (Targets([Rectangle("save", 900.0, 20.0, 80.0, 24.0, weight=2.0)]), Targets([])),
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
        PredictionMessage(0.508, 871.5, 251.0, EndpointLaw(220.5, -12.0, 180.25, 4.5), "ballistic", 0.35),
        PredictionMessage(0.5),
        PredictionMessage(0.508, 871.5, 251.0, None, "ballistic", 0.35, [Likely("save", 0.8125)]),
    ),
    "cursor": (Cursor(0.508, 652.0, 356.0, 4.0),),
    "choice": (
        ChoiceMessage("save", 0.8125, "propose", 0.508, "predicted"),
        ChoiceMessage("save", 0.25, "retract", 0.75),
        ChoiceMessage("print", 0.375, "propose", 0.758, "entered"),
        ChoiceMessage("place 7", 0.625, "propose", 0.508, "predicted", PlaceSquare(871.0, 248.0, 32.0)),
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
