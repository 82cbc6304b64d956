"""Pointing transfer functions: hand speed to cursor speed."""
