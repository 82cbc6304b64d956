"""The service: a page with the embedded sample, health, and (from a later release on) the WebSocket."""
