"""A moving camera: its velocity and the depth of a point, by an unknown input observer and by a filter."""
