"""The closed pointing loop with simulated people: data with known truth, labelled as simulated."""

from pointpred.simulation.circle import Condition, simulate_circle, thesis_setup
from pointpred.simulation.guarded import Claim, Guard, move_guarded
from pointpred.simulation.person import Person, people
from pointpred.simulation.plan import Aim, Setup

__all__ = [
    "Aim",
    "Claim",
    "Condition",
    "Guard",
    "Person",
    "Setup",
    "move_guarded",
    "people",
    "simulate_circle",
    "thesis_setup",
]
