"""What a person plans before a movement: where to aim, in how many pieces, how long each takes."""

from __future__ import annotations

from collections.abc import Sequence
from math import exp, hypot, log2
from typing import Annotated

from pointpred.compiled import law
from pointpred.layout import Layout
from pointpred.simulation.loop import PIECES_MOST, Settings
from pointpred.simulation.person import Traits

PATIENCE_S = 5.0
"""After this many seconds a person clicks where the cursor is."""
SMALLEST_PIECE_S = 0.16
LATER_PIECE = 0.65
"""Duration of a later, shorter piece as a share of the first one's."""
MOST_AIM_OFF = 0.33
"""Largest offset of the aim from the centre, as a share of the target's width."""
FURTHER_PIECE = 0.55
"""How likely a novice adds a third piece, and a fourth; an expert never does."""


class PieceDraws(Layout):
    """The chance in a piece: standard normal numbers unless it says otherwise; uniform ones are in [0, 1]."""

    share: float
    """Normal in the last piece, uniform in the others."""
    duration: float
    skew: float
    turn: float
    curve: float
    until: float
    """Uniform."""
    pause: float
    """Standard exponential; none after the last piece."""


class Draws(Layout):
    """The chance in a plan: standard normal numbers, the number of pieces, and the chance in each."""

    friction: float
    rate: float
    aim_x: float
    aim_y: float
    reaction: float
    verify: float
    press: float
    count: float
    pieces: Annotated[Sequence[PieceDraws], PIECES_MOST]


@law
def varied(spread: float, normal: float) -> float:
    """A factor near 1, bounded."""
    return exp(spread * min(max(normal, -2.5), 2.5))


@law
def plan_piece(settings: Settings, traits: Traits, draws: Draws, number: int, first_s: float) -> None:
    """Share, duration, skew, turn, curvature, and when the next phase begins, of one piece."""
    piece, d = settings.pieces[number], draws.pieces[number]
    last = number == int(draws.count) - 1
    share = traits.reach + traits.reach_sd * d.share if last else 0.60 + (0.88 - 0.60) * d.share
    duration = first_s * (1.0 if number == 0 else LATER_PIECE) * varied(0.10, d.duration)
    duration = max(duration, SMALLEST_PIECE_S)
    until = 0.78 + (0.94 - 0.78) * d.until
    if not last:
        until = 0.90 + (1.0 - 0.90) * d.until + traits.pause_s * d.pause / duration
    piece.share = max(share, 0.3)
    piece.duration_s = duration
    piece.skew = min(max(traits.skew + 0.08 * d.skew, -0.2), 0.6)
    piece.turn = traits.turn_sd * d.turn
    piece.curve = traits.curvature + 0.4 * traits.turn_sd * d.curve
    piece.until = min(until, 1.6)


@law
def plan(settings: Settings, traits: Traits, draws: Draws, x: float, y: float, width: float) -> None:
    """Plan a movement to a target of ``width`` px, whose centre lies ``x y`` px from the start.

    The aim scatters about the centre, always well inside the target.
    """
    settings.b1 = traits.friction * varied(0.05, draws.friction)
    settings.rate = traits.rate * varied(0.08, draws.rate)
    settings.muscle_s = traits.muscle_s
    settings.delay_s = traits.delay_s
    settings.noise = traits.noise
    settings.tremor = traits.tremor_m_s
    settings.target_x, settings.target_y, settings.radius = x, y, 0.5 * width
    off_x, off_y = draws.aim_x * traits.aim_sd * width, draws.aim_y * traits.aim_sd * width
    shrink = min(1.0, MOST_AIM_OFF * width / max(hypot(off_x, off_y), 1e-9))
    settings.aim_x, settings.aim_y = x + shrink * off_x, y + shrink * off_y
    settings.reaction_s = traits.reaction_s * varied(0.18, draws.reaction)
    settings.verify_s = traits.verify_s * varied(0.25, draws.verify)
    settings.press_s = traits.press_s * varied(0.15, draws.press)
    settings.patience_s = PATIENCE_S
    settings.count = draws.count
    first_s = traits.base_s + traits.per_bit_s * log2(hypot(x, y) / width + 1.0)
    for number in range(int(draws.count)):
        plan_piece(settings, traits, draws, number, first_s)
