"""Pointing transfer functions: from the motion of the hand to the motion of the cursor."""

from pointpred.transfer.assistance import AssistedTransfer, GuardedTransfer
from pointpred.transfer.curve import GainCurve
from pointpred.transfer.files import SavedTransfer, load_transfer, named_transfer, save_transfer
from pointpred.transfer.functions import (
    Arctan,
    ConstantGain,
    HeldPolynomial,
    PolynomialFunction,
    SigmoidGain,
    TransferFunction,
    averaged_gain,
)
from pointpred.transfer.identification import (
    Identification,
    PolynomialIdentifier,
    differentiated_speeds,
    euler_speeds,
)
from pointpred.transfer.learner import TransferLearner
from pointpred.transfer.pixels import PixelTransfer

__all__ = [
    "Arctan",
    "AssistedTransfer",
    "ConstantGain",
    "GainCurve",
    "GuardedTransfer",
    "HeldPolynomial",
    "Identification",
    "PixelTransfer",
    "PolynomialFunction",
    "PolynomialIdentifier",
    "SavedTransfer",
    "SigmoidGain",
    "TransferFunction",
    "TransferLearner",
    "averaged_gain",
    "differentiated_speeds",
    "euler_speeds",
    "load_transfer",
    "named_transfer",
    "save_transfer",
]
