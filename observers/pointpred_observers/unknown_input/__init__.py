"""Unknown input observers over a box of varying parameters."""
