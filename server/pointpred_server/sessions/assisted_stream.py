"""Sessions whose cursor the service moves: counts in, the assisted cursor and predictions out."""

from __future__ import annotations

from collections.abc import Mapping
from math import hypot
from pathlib import Path

import numpy as np

from pointpred.errors import EventError
from pointpred.protocol.client_messages import Assist, Configure, Hello, cpi_of, dpi_of
from pointpred.protocol.decoding import check_numbers
from pointpred.protocol.errors import ProtocolError
from pointpred.protocol.frames import Aim, Frame
from pointpred.protocol.server_messages import Cursor, encode
from pointpred.records import LARGEST, FloatArray
from pointpred.regions import as_normal
from pointpred.transfer import ConstantGain, GuardedTransfer, SigmoidGain
from pointpred.transfer.assistance import UNGUIDED
from pointpred_server.sessions.observer import SessionObserver
from pointpred_server.sessions.outbox import Outbox
from pointpred_server.sessions.pipelines import NO_COEFFICIENTS
from pointpred_server.sessions.prediction_stream import Finish, PredictionStream
from pointpred_server.sessions.work import Slices


def open_stream(hello: Hello, coefficients: Mapping[str, Path] = NO_COEFFICIENTS) -> PredictionStream:
    """The stream that a client asks for; raises ProtocolError."""
    if hello.assist is None:
        return PredictionStream(hello, coefficients=coefficients)
    return AssistedStream(hello, hello.assist, coefficients=coefficients)


class AssistedStream(PredictionStream):
    """Counts move the cursor, and the pipeline predicts from where the cursor then is.

    The first event of the session says where the cursor stands before it; positions in later ones are not
    used: the client learns later where the cursor is. A reset leaves the cursor where it is.
    """

    def __init__(
        self,
        hello: Hello,
        assist: Assist,
        observer: SessionObserver | None = None,
        coefficients: Mapping[str, Path] = NO_COEFFICIENTS,
    ) -> None:
        """Raises ProtocolError as ``PredictionStream`` does, and where the hello has no counts per inch."""
        super().__init__(hello, observer, coefficients)
        self.transfer = _transfer(hello, assist)
        self.place: tuple[float, float] | None = None
        """The cursor, px; ``None`` before the first event."""
        self.added_px = 0.0
        self._guidance: tuple[float, ...] = ()  # the newest endpoint and its covariance

    def take_in(self, table: FloatArray, outbox: Outbox) -> Slices[Finish]:
        """As ``PredictionStream.take_in``, event by event: the prediction after each guides the next."""
        check_numbers(table)
        missing = np.isnan(table[:, 3])
        if missing.any():
            path = f"$.events[{int(missing.argmax())}][3]"
            sentence = "assistance needs counts: dx and dy must be numbers"
            raise ProtocolError("bad_field", sentence, path, field="dx")
        error, used = self._in_order(table)
        before = self._memories_for_places()
        used, predictions = yield from self._moved(used)
        return (yield from self._decide(table, error, used, predictions, outbox, before))

    def take_in_whole(self, table: FloatArray, outbox: Outbox) -> Finish | None:
        """Frames are used one by one: the client is told for each where the cursor is."""
        return None

    def take_in_last(self, table: FloatArray, outbox: Outbox) -> Finish | None:
        """Every prediction is needed, to guide the next report."""
        return None

    def feed_event(self, row: tuple[float, ...], outbox: Outbox) -> bool:
        """As ``PredictionStream.feed_event``: the one event of most frames, without a table."""
        if self.place is None or self.observer or self._trial.running or self.tracker or self.hello.places:
            return False
        t, x, y, dx, dy, buttons = row
        if not (abs(x) <= LARGEST and abs(y) <= LARGEST):  # not used, but ``take_in`` refuses them
            return False
        memory, before = self.transfer.remembered(), (self.place, self.added_px)
        prediction: tuple[float, ...] | None = None
        try:
            place = self._step(t, *self.place, dx, dy)
            if place is not None:
                answer = self.pipeline.advance((t, *place, dx, dy, buttons))
                prediction = answer if answer[0] == answer[0] else None
        finally:
            if prediction is None:
                self.transfer.recall(memory)
                self.place, self.added_px = before
        if prediction is None:
            return False
        self._guide(prediction)
        self.events += 1
        self._last_t = t
        outbox.predict([self._cursor(t), self._encode_row(prediction)], 1)
        return True

    def configure(self, message: Configure) -> None:
        """As ``PredictionStream.configure``; ``assist`` replaces the former one. Raises ProtocolError."""
        transfer = None if message.assist is None else _transfer(self.hello, message.assist)
        super().configure(message)
        if transfer is not None:
            self.transfer = transfer

    def _check_assist(self, message: Configure) -> None:
        """Assistance may be changed here."""

    def _forget(self) -> None:
        super()._forget()
        self.transfer.reset()
        self._guidance = ()

    def _moved(self, table: FloatArray) -> Slices[tuple[FloatArray, FloatArray]]:
        """The events where the cursor is, and their predictions; raises EventError.

        Nothing has changed then, nor where a law fails.
        """
        stages = (self.transfer, self.pipeline.differentiator, self.pipeline.predictor)
        memories = [stage.remembered() for stage in stages]
        before = self.place, self.added_px, self._guidance
        moved, predictions, complete = table.copy(), np.empty((len(table), 10)), False
        try:
            for part in self.costs.slices_of(len(table)):
                if part.start:
                    yield
                for i, (t, x, y, dx, dy, buttons) in enumerate(table[part].tolist(), part.start):
                    place = self._step(t, x, y, dx, dy)
                    answer = None if place is None else self.pipeline.advance((t, *place, dx, dy, buttons))
                    if place is None or answer is None or answer[0] != answer[0]:
                        raise EventError(f"t = {t!r} s with counts {dx!r}, {dy!r} cannot be used")
                    moved[i, 1:3], predictions[i] = place, answer
                    self._guide(answer)
            complete = True
        finally:
            if not complete:
                for stage, memory in zip(stages, memories, strict=True):
                    stage.recall(memory)
                self.place, self.added_px, self._guidance = before
        return moved, predictions

    def _step(self, t: float, x: float, y: float, dx: float, dy: float) -> tuple[float, float] | None:
        """Where one report brings the cursor, within the screen; ``None`` where it is refused."""
        x, y = self.place or (x, y)
        guidance = UNGUIDED
        if self._guidance:
            to_x, to_y, sxx, sxy, syy = self._guidance
            if abs(to_x - x) <= LARGEST and abs(to_y - y) <= LARGEST:
                guidance = (to_x - x, to_y - y, sxx, sxy, syy)
        accepted, px, py, added_x, added_y = self.transfer.advance((t, dx, dy, *guidance))
        if accepted != accepted:
            return None
        self.added_px += hypot(added_x, added_y)
        screen = self.hello.screen
        width, height = (screen.width_px, screen.height_px) if screen else (None, None)
        self.place = _within(x + px, width), _within(y + py, height)
        return self.place

    def _guide(self, prediction: tuple[float, ...]) -> None:
        """The newest prediction guides the next report."""
        _, x, y, sxx, sxy, syy, _, _, tail, _ = prediction
        self._guidance = (x, y, *as_normal(sxx, sxy, syy, tail)) if x == x else ()

    def _cursor(self, t: float) -> str:
        assert self.place is not None
        return encode(Cursor(t, *self.place, self.added_px)).decode()

    def _frames(self, predictions: FloatArray, aims: list[Aim] | None = None) -> tuple[list[Frame], int]:
        """The cursor goes before the predictions, as text in either encoding."""
        frames, count = super()._frames(predictions, aims)
        return [self._cursor(float(predictions[-1, 0])), *frames], count


def _transfer(hello: Hello, assist: Assist) -> GuardedTransfer:
    cpi = cpi_of(hello)
    if cpi is None:
        sentence = "assistance needs the counts per inch of the device"
        raise ProtocolError("bad_field", sentence, "$.device.cpi", field="cpi")
    function = ConstantGain(assist.gain) if assist.function == "constant" else SigmoidGain()
    return GuardedTransfer(function, cpi=cpi, dpi=dpi_of(hello), rho=assist.rho, strength=assist.strength)


def _within(place: float, size: float | None) -> float:
    """A coordinate on a screen of a size; without one, within what a pipeline takes."""
    if size is None:
        return min(max(place, -LARGEST), LARGEST)
    return min(max(place, 0.0), max(size - 1.0, 0.0))
