"""Logs of input devices: one file for each format."""
