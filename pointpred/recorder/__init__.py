"""Sessions on disk, when asked for: written while they last, listed and deleted."""
