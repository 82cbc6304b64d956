"""The Python client: the calls of the browser client, for scripts and tests."""

from pointpred.client.async_connection import AsyncConnection, connect_async
from pointpred.client.connection import Connection, connect
from pointpred.client.session import ServiceError

__all__ = ["AsyncConnection", "Connection", "ServiceError", "connect", "connect_async"]
