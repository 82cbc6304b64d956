"""Boot two instances of the unit in deploy/ under systemd in a container, use them, kill one and stop it.

``python -m tests.operations.boot`` from the project's root, as root, with Debian's systemd-container. It
takes a minute. Nothing of this machine is changed: /etc, /var and /run of the
container are in memory, everything else is read-only, and it has no network.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path

from evidence import ROOT
from tests.operations.monitoring import DEPLOY

TOKEN = "sesame-open-12345"
LIMIT_S = 1200
LAUNCHER = """#!/bin/sh
export LD_LIBRARY_PATH=/opt/python/lib PYTHONHOME=/opt/python
export PYTHONPATH=/srv/pointpred:/srv/pointpred/server:/srv/packages
exec /opt/python/bin/{python} -P {arguments} "$@"
"""
TARGET = "[Unit]\nWants=pointpred@8765.service pointpred@8766.service check.service\nAllowIsolate=yes\n"
CHECK_UNIT = "[Service]\nType=oneshot\nExecStart=/trial/check\nTimeoutStartSec=infinity\n"
CHECK = r"""#!/bin/bash
exec >/trial/out.txt 2>&1
url=http://127.0.0.1
answers() { for i in $(seq $2); do curl -s -f -m 5 -o /dev/null $url:$1 && return; sleep 1; done; return 1; }
check() { if "${@:2}"; then echo "passed: $1"; else echo "FAILED: $1"; fi; }
main() { systemctl show -p MainPID --value pointpred@8765; }
active() { test "$(systemctl is-active pointpred@$1)" = "$2"; }
refused() { test "$(curl -s -o /dev/null -w '%{http_code}' $url:8765/v1/predictors)" = 401; }
recorded() { grep -q . /var/lib/pointpred/recordings/*_samples.csv; }
private() { test "$(stat -c '%a %U' /var/lib/pointpred)" = "700 pointpred"; }
bare() { grep -q '^CapBnd:.0*$' /proc/$(main)/status && grep -q '^NoNewPrivs:.1' /proc/$(main)/status; }
filters() { sed -n 's/^Seccomp_filters:[[:space:]]*//p' /proc/$1/status; }
filtered() { test "$(filters $(main))" -gt "$(filters 1)"; }  # the container has filters of its own
confined() { touch /etc/here && ! nsenter -t $(main) -m touch /etc/there; }
limited() { test "$(systemctl show -p MemoryMax --value pointpred@8765)" = 1073741824; }
secret() { ! journalctl | grep -q SECRET && ! systemctl show 'pointpred@*' | grep -q SECRET; }
check "a service becomes ready" answers 8765/readyz 900
check "the other one becomes ready" answers 8766/readyz 900
check "each shows its metrics" answers 18765/metrics 5
check "the other one shows its own" answers 18766/metrics 5
check "a session is predicted" /trial/session
check "who has no token is refused" refused
check "the session was recorded" recorded
check "its folder is private" private
check "it has no capability" bare
check "system calls are filtered" filtered
check "it writes nowhere else" confined 2>/dev/null
check "its memory is limited" limited
kill -KILL $(main); sleep 1
check "the other one goes on" answers 8766/readyz 1
check "the killed service is started again" answers 8765/readyz 90
before=$(date +%s.%N); systemctl stop pointpred@8765
echo "the stop took $(echo "$(date +%s.%N) - $before" | bc 2>/dev/null || true) s"
check "it stopped by itself" active 8765 inactive
check "the other one still goes on" active 8766 active
check "no token is in the log or in the unit" secret
systemctl poweroff --force
"""
SESSION = f"""
from pointpred.client import connect
with connect("http://127.0.0.1:8765", token="{TOKEN}", timeout_s=600) as service:
    service.send([(1 + i / 100, i * i / 10, 0.0) for i in range(60)])
    assert list(service.predictions())[-1].x is not None
"""


def main() -> None:
    """Prepare the files of the container, boot it, and print what was checked."""
    if os.geteuid() or shutil.which("systemd-nspawn") is None:
        raise SystemExit(
            "run this as root, where systemd-nspawn (Debian package systemd-container) is installed"
        )
    with tempfile.TemporaryDirectory() as folder:
        trial = Path(folder)
        for name, content in files().items():
            path = trial / name
            path.write_text(content)
            path.chmod(0o755 if content.startswith("#!") else 0o644)
        (trial / "pointpred.env").chmod(0o600)
        done = subprocess.run(
            command(trial), stdin=subprocess.DEVNULL, capture_output=True, timeout=LIMIT_S, check=False
        )
        out = trial / "out.txt"
        text = out.read_text() if out.exists() else done.stdout.decode(errors="replace")
    print(text)
    sys.exit("FAILED" in text or "passed" not in text)


def files() -> dict[str, str]:
    """What the container needs beside the system's own files, by name."""
    user = "pointpred:x:990:990::/var/lib/pointpred:/usr/sbin/nologin\n"
    environment = (DEPLOY / "pointpred.env").read_text()
    for name, value in {"TOKEN": TOKEN, "RECORD": "/var/lib/pointpred/recordings"}.items():
        environment = re.sub(
            rf"^#POINTPRED_{name}=.*$", f"POINTPRED_{name}={value}", environment, flags=re.MULTILINE
        )
    python = f"python{sys.version_info.major}.{sys.version_info.minor}"
    return {
        "passwd": Path("/etc/passwd").read_text() + user,
        "group": Path("/etc/group").read_text() + "pointpred:x:990:\n",
        "pointpred.env": environment,
        "pointpred@.service": (DEPLOY / "pointpred@.service").read_text(),
        "trial.target": TARGET,
        "check.service": CHECK_UNIT,
        "check": CHECK.replace("SECRET", TOKEN),
        "session.py": SESSION,
        "session": LAUNCHER.format(python=python, arguments="/trial/session.py"),
        "pointpred": LAUNCHER.format(python=python, arguments="-m pointpred"),
    }


def command(trial: Path) -> list[str]:
    """How the container is booted."""
    units = "/etc/systemd/system"
    read_only = {
        sys.base_prefix: "/opt/python",
        str(ROOT): "/srv/pointpred",
        sysconfig.get_path("purelib"): "/srv/packages",
        str(trial / "pointpred"): "/opt/pointpred/bin/pointpred",
        str(trial / "pointpred.env"): "/etc/pointpred/pointpred.env",
        **{str(trial / name): f"/etc/{name}" for name in ("passwd", "group")},
        **{
            str(trial / name): f"{units}/{name}"
            for name in ("pointpred@.service", "trial.target", "check.service")
        },
    }
    options = [
        "--register=no",
        "--keep-unit",
        "--private-network",
        "--volatile=yes",
        "--directory=/",
        "--boot",
    ]
    binds = [f"--bind-ro={here}:{there}" for here, there in read_only.items()]
    words = ["systemd.unit=trial.target", "systemd.firstboot=no"]
    return ["systemd-nspawn", *options, *binds, f"--bind={trial}:/trial", *words]


if __name__ == "__main__":
    main()
