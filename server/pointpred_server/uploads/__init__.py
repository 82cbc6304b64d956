"""Uploaded recordings: received, bounded in size before they are unpacked, opened and scored."""
