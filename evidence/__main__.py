"""Write the pages that are made, or measure.

``python -m evidence`` writes every page from the code and from the numbers in ``evidence``: ``make docs``.
``python -m evidence NAME [PART] [ARGUMENT ...]`` measures a question, all arguments going to what measures;
PART is ``measure`` unless given. ``python -m evidence NAME PART --help`` says what it does.
"""

from __future__ import annotations

import runpy
import sys

from evidence import EVIDENCE


def measurements() -> dict[str, list[str]]:
    """What can be measured: the parts of every question. What measures the code itself runs as scripts."""
    found: dict[str, list[str]] = {}
    for path in sorted([*EVIDENCE.glob("*/*.py"), *EVIDENCE.glob("*/*/__main__.py")]):
        name, part, *_ = path.relative_to(EVIDENCE).with_suffix("").parts
        if name != "house" and 'if __name__ == "__main__":' in path.read_text(encoding="utf-8"):
            found.setdefault(name, []).append(part)
    return found


def main(words: list[str]) -> None:
    """Write, or run what measures; raises SystemExit where there is no such thing."""
    known = measurements()
    if not words:
        from evidence.pages import write

        write()
        return
    name, *rest = words
    part = rest.pop(0) if rest and rest[0] in known.get(name, ()) else "measure"
    if part not in known.get(name, ()):
        listed = "\n".join(f"  {one} {' | '.join(parts)}" for one, parts in known.items())
        text = f"{__doc__}\n{listed}"
        if name in {"-h", "--help"}:
            print(text)
            return
        raise SystemExit(f"nothing is measured as {' '.join(words)!r}\n\n{text}")
    module = f"evidence.{name}.{part}"
    sys.argv = [f"python -m evidence {name} {part}", *rest]
    runpy.run_module(module, run_name="__main__", alter_sys=True)


if __name__ == "__main__":
    main(sys.argv[1:])
