"""Sessions kept on disk when asked: written beside the traffic, listed and deleted."""
