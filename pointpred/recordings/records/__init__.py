"""Nested values, as JSON and MATLAB files hold them, as tables."""
