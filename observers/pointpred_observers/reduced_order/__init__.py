"""Observers of reduced order from a reversed interconnection (section 3.3)."""
