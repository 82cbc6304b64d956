"""The cursor of the screen: X11, Windows, macOS, and its place joined with the counts of a mouse."""
