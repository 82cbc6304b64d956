"""From a socket into a session and back; a client that comes before code is warm."""
