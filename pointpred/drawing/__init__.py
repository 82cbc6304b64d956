"""Figures in one style: the canvas, and panels of lines."""
