"""Mice through the kernel's input nodes, /dev/input/event*."""
