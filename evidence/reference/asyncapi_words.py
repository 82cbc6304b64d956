"""The texts of the AsyncAPI document besides the message types; the tests compare the lists with the code."""

from __future__ import annotations

from pointpred.protocol.client_messages import SUBPROTOCOL

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
