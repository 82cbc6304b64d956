"""Leave with 0 where the service in this container says that it is ready: no shell, no further program."""

from __future__ import annotations

import os
import sys
from urllib.request import ProxyHandler, build_opener

port = os.environ.get("POINTPRED_PORT", "8765")
try:
    with build_opener(ProxyHandler({})).open(f"http://127.0.0.1:{port}/readyz", timeout=2) as answer:
        sys.exit(answer.status != 200)
except OSError as error:
    sys.exit(f"not ready: {error}")
