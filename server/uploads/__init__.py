"""Recordings that are sent to be scored: bounded, unpacked, spooled."""
