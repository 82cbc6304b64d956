"""Regressors and their excitation: gradient and nonlinear (section 3.3)."""
