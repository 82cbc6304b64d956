"""What ``pointpred doctor`` looks at where the service is installed."""

from __future__ import annotations

from pointpred.cli.doctor import Finding
from pointpred.errors import SourceError

LOOPBACK = "127.0.0.1"


def port() -> list[Finding]:
    """Whether the page can be served."""
    from pointpred_server.cli.serve import PORT, TRIES
    from pointpred_server.listening import listen

    try:
        with listen(LOOPBACK, PORT, TRIES) as opened:
            free = opened.getsockname()[1]
    except SourceError as error:
        return [Finding("port", "broken", str(error), "pointpred serve --port 0 takes any free one")]
    if free != PORT:
        return [Finding("port", "good", f"{PORT} is in use; 'pointpred serve' takes {free}")]
    return [Finding("port", "good", f"{PORT} is free on {LOOPBACK}")]
