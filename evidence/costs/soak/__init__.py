"""The soak: mixed clients against a real service for an hour, and what must not change meanwhile."""
