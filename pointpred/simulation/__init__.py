"""The closed pointing loop with simulated people: data with known truth, labelled as simulated."""

from pointpred.simulation.circle import Condition, simulate_circle, thesis_setup
from pointpred.simulation.movement import Aim, Setup
from pointpred.simulation.person import Person, people

__all__ = [
    "Aim",
    "Condition",
    "Person",
    "Setup",
    "people",
    "simulate_circle",
    "thesis_setup",
]
