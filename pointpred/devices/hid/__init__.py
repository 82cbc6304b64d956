"""HID mice: their report descriptors, and the motion, wheels and buttons in their reports."""
