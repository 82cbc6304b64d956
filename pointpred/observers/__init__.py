"""Nonlinear observers with certificates that are proved: chapters 3 and 4 of the thesis."""
