"""The Python client: the calls of the browser client, for scripts and tests. Needs the extra ``client``."""

from pointpred.extras import require

require("client", "the client of a service")

from pointpred.client.connection import AsyncConnection, Connection, connect, connect_async  # noqa: E402
from pointpred.client.session import ServiceError  # noqa: E402

__all__ = ["AsyncConnection", "Connection", "ServiceError", "connect", "connect_async"]
