"""Let the service in this container predict a movement of the sample; leave with 1 where it does not."""

from __future__ import annotations

import os
import sys

from pointpred.client import ServiceError, connect
from pointpred.datasets import sample
from pointpred.errors import SourceError

port, token = os.environ.get("POINTPRED_PORT", "8765"), os.environ.get("POINTPRED_TOKEN")
events = sample().rows(0)
try:
    with connect(f"http://127.0.0.1:{port}", token=token, predictor="switched") as session:
        session.send(events)
        predicted = session.columns()
except (ServiceError, SourceError) as error:
    sys.exit(f"not predicted: {error}")
print(f"predicted a movement of {len(events)} events, {len(predicted)} times")
