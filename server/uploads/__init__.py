"""Recordings that are sent to be scored: their size bounded before they are unpacked, spooled, scored."""
