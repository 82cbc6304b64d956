"""The service: the live page, the WebSocket, and HTTP for scores, health and metrics."""
