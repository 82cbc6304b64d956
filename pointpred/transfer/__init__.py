"""Pointing transfer functions: from the motion of the hand to the motion of the cursor."""

from pointpred.transfer.assisted import AssistedTransfer
from pointpred.transfer.assisted_guarded import GuardedTransfer
from pointpred.transfer.identification import Identification, PolynomialIdentifier
from pointpred.transfer.known import Arctan, ConstantGain, SigmoidGain, TransferFunction
from pointpred.transfer.pixels import PixelTransfer
from pointpred.transfer.polynomial import PolynomialFunction, averaged_gain
from pointpred.transfer.speeds import differentiated_speeds, euler_speeds

__all__ = [
    "Arctan",
    "AssistedTransfer",
    "ConstantGain",
    "GuardedTransfer",
    "Identification",
    "PixelTransfer",
    "PolynomialFunction",
    "PolynomialIdentifier",
    "SigmoidGain",
    "TransferFunction",
    "averaged_gain",
    "differentiated_speeds",
    "euler_speeds",
]
