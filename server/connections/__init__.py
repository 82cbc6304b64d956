"""From a socket into a session and back, and how a conversation ends."""
