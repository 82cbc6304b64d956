"""``python -m pointpred.datasets.generate``: generate the embedded sample again, to the same bytes."""

from __future__ import annotations

from pointpred.datasets import embedded

if __name__ == "__main__":
    for path in embedded.write():
        print(f"{path.name}: {path.stat().st_size} bytes")
