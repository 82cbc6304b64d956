"""What can be pointed at: how likely each is, the prediction given these, proposals, and a ledger of them."""

from pointpred.targets.chooser import Choice, Chooser, PlaceChooser
from pointpred.targets.ledger import Ledger, Movement
from pointpred.targets.prefetch import Prefetcher
from pointpred.targets.rectangles import MOST_TARGETS, Target, around

__all__ = [
    "MOST_TARGETS",
    "Choice",
    "Chooser",
    "Ledger",
    "Movement",
    "PlaceChooser",
    "Prefetcher",
    "Target",
    "around",
]
