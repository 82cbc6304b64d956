#!/bin/sh
# The steps of the Dockerfile, one a function. The Dockerfile runs them one by one; where no Docker engine
# runs, `container/steps.sh rehearse` runs all of them in a temporary folder, starts the service as the image
# would (another user, nothing writable, nothing but the installed folder), asks its health check, and lets
# it predict a movement.
set -eu

PYTHON="${PYTHON:-python3.11}"
SOURCE="${SOURCE:-.}"
APP="${APP:-/opt/pointpred}"
PORT="${PORT:-8765}"
USER_ID=65532

step_wheel() { # build the wheels of the library and of the service
    "$PYTHON" -m venv "$APP"
    "$APP/bin/python" -m pip wheel --quiet --no-deps --disable-pip-version-check -w "$APP/wheels" \
        "$SOURCE" "$SOURCE/server"
}

step_install() { # install them with the versions the project is tested with
    "$APP/bin/python" -m pip install --quiet --disable-pip-version-check --no-cache-dir \
        -c "$SOURCE/constraints.txt" "$APP"/wheels/*.whl
    rm -r "$APP/wheels"
    cp "$SOURCE/container/healthy.py" "$APP/healthy.py"
}

rehearse() { # every step, then what the image does: serve, and the health check
    folder="$(mktemp -d)"
    trap 'rm -rf "$folder"' EXIT
    chmod 755 "$folder"
    APP="$folder/pointpred"
    for step in wheel install; do
        echo "step: $step"
        "step_$step"
    done
    echo "step: serve, read-only, as user $USER_ID"
    TOKEN="rehearsal-$$-$(date +%s)"
    export APP PORT USER_ID TOKEN
    unshare --mount --propagation private sh -c '
        for place in / /dev/shm; do mount -o remount,bind,ro "$place"; done
        cd "$APP"
        exec setpriv --reuid "$USER_ID" --regid "$USER_ID" --clear-groups --no-new-privs --bounding-set=-all \
            env -i HOME=/nonexistent PYTHONDONTWRITEBYTECODE=1 PYTHONUNBUFFERED=1 \
            POINTPRED_PORT="$PORT" POINTPRED_TOKEN="$TOKEN" \
            "$APP/bin/pointpred" serve --host 0.0.0.0
    ' &
    served=$!
    trap 'kill "$served" 2>/dev/null || true; rm -rf "$folder"' EXIT
    begun="$(date +%s%N)"
    until POINTPRED_PORT="$PORT" "$APP/bin/python" -I "$APP/healthy.py" 2>/dev/null; do
        kill -0 "$served" || { echo "the service ended before it was ready" >&2; exit 1; }
        [ "$(($(date +%s%N) - begun))" -lt 60000000000 ] || { echo "not ready within 60 s" >&2; exit 1; }
        sleep 0.1
    done
    echo "healthy after $((($(date +%s%N) - begun) / 1000000)) ms"
    POINTPRED_PORT="$PORT" POINTPRED_TOKEN="$TOKEN" "$APP/bin/python" -I "$SOURCE/container/predicts.py"
    kill -TERM "$served"
    wait "$served" && code=0 || code=$?
    echo "left with $code after SIGTERM"
}

case "${1:-}" in
wheel | install) "step_$1" ;;
rehearse) rehearse ;;
*)
    echo "usage: $0 wheel | install | rehearse" >&2
    exit 2
    ;;
esac
