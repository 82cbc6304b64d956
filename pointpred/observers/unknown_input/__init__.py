"""Observers that need not know their input, over a box of varying parameters."""
