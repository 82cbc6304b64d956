"""The image carries the machine code of everything that its service runs."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
SERVED = """
import runpy, sys
from numba.core.dispatcher import Dispatcher

def compiled():
    modules = [module for name, module in sorted(sys.modules.items()) if name.startswith("pointpred")]
    found = [law for module in modules for law in vars(module).values() if isinstance(law, Dispatcher)]
    laws = {id(law): law for law in found}
    return {(law.__module__, law.__name__, str(way)) for law in laws.values() for way in law.signatures}

runpy.run_path("container/warm.py", run_name="__main__")
kept = compiled()
assert len(kept) > 20, kept

from pointpred.registry import REGISTRY
from pointpred_server.uploads.recordings import score_body
from pointpred_server.sessions.pointing import PointingSession
from pointpred.protocol.server_messages import Limits
from pointpred_server.compiling.compiler import compile_all
from tests.unit.talking import events, packed

compile_all()
rows = [(0.01 * i, 7.0 * i, 3.0 * i, 4, 2, 0) for i in range(60)]
for name in REGISTRY:
    session = PointingSession("here", Limits(), 0.0)
    for text in (
        '{"type":"hello","version":1,"predictor":"%s","device":{"cpi":800},"encoding":"binary"}' % name,
        '{"type":"trial","action":"start","target":{"x":413,"y":177,"width":20}}',
        packed(*rows[:1]), packed(*rows[1:9]), packed(*rows[9:]),
        '{"type":"trial","action":"end"}',
    ):
        session.receive(text, 1.0)
    session.finish(session.work())
    said = b"".join(a if isinstance(a, bytes) else a.encode() for a in session.outbox.take())
    assert b'"score"' in said, said
body = "user,trial,t_s,x_px,y_px\\n" + "".join(f"ann,1,{t},{x},{y}\\n" for t, x, y, *_ in rows)
score_body(body.encode(), ())
print(sorted(compiled() - kept))
"""


def test_what_the_service_runs_is_compiled_when_the_image_is_built() -> None:
    """After the image's own step sessions and a posted recording compile nothing anew."""
    environment = {**os.environ, "POINTPRED_COMPILED": "1", "PYTHONPATH": str(ROOT)}
    ran = subprocess.run(
        [sys.executable, "-W", "error", "-c", SERVED],
        cwd=ROOT,
        env=environment,
        capture_output=True,
        text=True,
    )
    assert ran.returncode == 0, ran.stderr
    assert ran.stdout.splitlines()[-1] == "[]"
