"""Mice through hidraw nodes: every report as the device sent it."""
