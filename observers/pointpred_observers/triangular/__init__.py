"""Triangular systems: steady states as polynomials, and the interlaced observer (chapter 4)."""
