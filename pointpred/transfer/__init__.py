"""Pointing transfer functions: from the motion of the hand to the motion of the cursor."""

from pointpred.transfer.known import Arctan, ConstantGain, SigmoidGain, TransferFunction
from pointpred.transfer.pixels import PixelTransfer

__all__ = ["Arctan", "ConstantGain", "PixelTransfer", "SigmoidGain", "TransferFunction"]
