"""One client's session: its pipeline, its trials, its targets and what it may ask. No sockets here."""
