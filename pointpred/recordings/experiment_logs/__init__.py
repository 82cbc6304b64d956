"""Logs of experiment software and of published data sets: one file for each format."""
