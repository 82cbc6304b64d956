"""The X11 cursor under Xvfb with xdotool: read, paired with emulated counts, its transfer function learnt."""

from __future__ import annotations

import numpy as np
import pytest

from pointpred.devices import screen_cursor
from pointpred.devices.cursor_paths import Pairing
from pointpred.devices.screen_cursor import ScreenCursor
from pointpred.devices.source import Report
from pointpred.errors import SourceError
from pointpred.reproduction.transfer_functions import CPI, DPI, best_polynomial, gain_error, simulate_trials
from pointpred.transfer import ConstantGain, SigmoidGain, TransferLearner
from tests.devices import live_hand
from tests.devices.evdev_mice import PLAIN, plug, told
from tests.devices.screens import HEIGHT, NOBODYS, WIDTH, Screen
from tests.devices.umockdev import Testbed

SEED, LOOKS = 31, 4


# python-xlib leaves the socket of a refused connection to the garbage collector
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
def test_the_cursor_is_where_xdotool_put_it_until_the_screen_goes(screen: Screen) -> None:
    with ScreenCursor(screen.name) as cursor:
        assert cursor.size == (WIDTH, HEIGHT)
        for place in ((3, 1000), (1919, 0)):
            assert screen.place(*place) == place
            assert cursor.position() == place
        screen.stop()
        with pytest.raises(SourceError, match=f"display {screen.name} is gone .* motor space"):
            cursor.position()
    with pytest.raises(SourceError, match=f"display {NOBODYS} cannot be opened"):
        ScreenCursor(NOBODYS)


def test_without_x11_it_is_said_what_else_there_is(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    monkeypatch.setenv("XDG_SESSION_TYPE", "tty")
    with pytest.raises(SourceError, match="DISPLAY is not set; set it, or predict in motor space"):
        ScreenCursor()
    monkeypatch.setenv("XDG_SESSION_TYPE", "wayland")
    monkeypatch.setenv("DISPLAY", ":0")
    with pytest.raises(SourceError, match="Wayland"):
        ScreenCursor()
    assert "transfer function" in screen_cursor.OTHERWISE


def test_the_sigmoid_is_learnt_nearly_as_well_as_a_polynomial_can(screen: Screen) -> None:
    """Emulated counts on a clock of their own; the cursor is looked at after every fourth report."""
    truth, now = SigmoidGain(), 0.0
    best = gain_error(best_polynomial(truth), truth)
    with ScreenCursor(screen.name) as cursor:
        learner = TransferLearner(cpi=CPI, dpi=DPI, size=cursor.size)
        pairing = Pairing(cursor, clock=lambda: now)
        begin = 0.0
        for trial in simulate_trials(truth, SEED):
            table = trial.table.copy()
            table[:, 1:3] += np.round((WIDTH / 2, HEIGHT / 2) - table[:, 1:3].mean(axis=0))
            learner.reset()
            screen.place(*table[0, 1:3])
            now = begin
            pairing.events([])
            for rows in (table[i : i + LOOKS] for i in range(0, len(table), LOOKS)):
                assert screen.place(*rows[-1, 1:3]) == tuple(rows[-1, 1:3])
                now = begin + rows[-1, 0]
                for event in pairing.events([Report(begin + r[0], r[3], r[4]) for r in rows]):
                    learner.update(event)
            begin = now + 0.5
    curve, found = learner.curve(), learner.identify().function
    assert found is not None
    error = gain_error(found, truth)
    assert best.largest < error.largest < 1.5 * best.largest
    assert curve.excited is not None
    assert curve.excited[0] < 0.03
    assert curve.excited[1] > 0.29
    assert curve.closest == "sigmoid"
    assert pairing.unpaired == learner.edges == 0


def test_a_constant_gain_is_learnt_from_a_device_and_a_screen_in_real_time(
    testbed: Testbed, screen: Screen
) -> None:
    node = plug(testbed, 5, PLAIN)
    peaks = [0.3, 0.05, 0.2, 0.12, 0.25, 0.08]
    screen.place(*live_hand.START)
    with live_hand.learn(testbed, node, screen) as child:
        assert told(child) == "ready"
        for sent in live_hand.work(testbed, node, screen, ConstantGain(4.0), peaks):
            while told(child) < sent:
                pass
        assert child.stdin
        child.stdin.close()
        said = told(child)
    assert (said["lost"], said["unpaired"]) == (0, 0)
    assert said["place"] == said["cursor"]
    curve = said["curve"]
    assert curve["excited"][0] < 0.06
    assert curve["excited"][1] > 0.22
    assert curve["gains"] == pytest.approx([4.0] * len(curve["gains"]), rel=0.05)
    assert curve["edges"] == 0
    assert curve["closest"] == "constant"
