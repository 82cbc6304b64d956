"""The service: a page, health, and (from the next release on) the WebSocket."""
