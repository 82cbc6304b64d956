"""Matrices as arguments, equalities and eigenvalues with their rounding, units that balance."""
