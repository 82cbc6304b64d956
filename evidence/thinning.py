"""SVG figures in fewer bytes: no digits below 0.1 px, no points on a line, no indentation."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path

SEEN_PX = 0.1
"""A point nearer than this to the line between its neighbours is left out."""

NUMBER = re.compile(r"-?\d+\.\d+(?:e-?\d+)?")
PATH = re.compile(r'(<path\b[^>]*?\bd=")([^"]*)(")')
GROUP = re.compile(r'<g( clip-path="[^"]*")?>((?:\s*<use [^>]*/>)+)\s*</g>')
STYLE = re.compile(r' style="([^"]*)"')
GLYPH_SCALE = "scale(0.015625)"
"""Outlines of letters are drawn in 64ths of a px."""


def save(svg: str, file: Path) -> None:
    """Write a figure, thinned."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(thinned(svg), encoding="utf-8")


def thin(file: Path) -> None:
    """Thin a figure that another program wrote."""
    file.write_text(thinned(file.read_text(encoding="utf-8")), encoding="utf-8")


def thinned(svg: str) -> str:
    r"""The same figure in fewer bytes.

    >>> thinned('<path d="M 0 0 \\nL 1.234567 0 \\nL 2.5 0.01 \\nL 3 7"/>')
    '<path d="M0 0L2.5 0L3 7"/>'
    """
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    svg = re.sub(r"<!--.*?-->", "", svg, flags=re.DOTALL)
    svg = PATH.sub(lambda m: m[1] + _outline(m) + m[3], svg)
    svg = re.sub(r'\b(x|y|width|height)="(-?[\d.]+)"', lambda m: f'{m[1]}="{_short(m[2])}"', svg)
    svg = re.sub(r'transform="([^"]*)"', _transform, svg)
    svg = STYLE.sub(lambda m: f' style="{m[1].replace(": ", ":").replace("; ", ";")}"', svg)
    svg = GROUP.sub(_shared_style, svg)
    svg = svg.replace(' transform="rotate(-0 ', ' transform="rotate(0 ')
    svg = re.sub(r' transform="rotate\(0 [^"]*"', "", svg)
    return re.sub(r">\s*\n\s*<", ">\n<", _classes(svg))


def _classes(svg: str) -> str:
    """Styles that stand more than once become classes."""
    often = [style for style, times in Counter(STYLE.findall(svg)).items() if times > 1]
    if not often:
        return svg
    names = {style: f"s{i}" for i, style in enumerate(often)}
    rules = "".join(f".{name}{{{style}}}" for style, name in names.items())
    svg = STYLE.sub(lambda m: f' class="{names[m[1]]}"' if m[1] in names else m[0], svg)
    end = svg.index(">", svg.index("<svg")) + 1
    return f"{svg[:end]}<style>{rules}</style>{svg[end:]}"


def _short(number: str, digits: int = 1) -> str:
    text = f"{float(number):.{digits}f}".rstrip("0").rstrip(".") if "." in number else number
    return "0" if text in {"-0", ""} else text


def _transform(match: re.Match[str]) -> str:
    if "scale" in match[1] or "matrix" in match[1]:
        return match[0]
    return f'transform="{NUMBER.sub(lambda m: _short(m[0], 2), match[1])}"'


def _outline(match: re.Match[str]) -> str:
    """Path data: a curve is rounded, a line of many points is simplified as well."""
    data = " ".join(match[2].split())
    if GLYPH_SCALE in match.string[match.end() : match.end() + 60]:
        return NUMBER.sub(lambda m: _short(m[0], 0), data)
    small = "id=" in match[1]
    digits = 2 if small else 1
    if small or re.search(r"[^MLZz\d.e\s-]", data):
        rounded = NUMBER.sub(lambda m: _short(m[0], digits), data)
        return re.sub(r" ?([A-Za-z]) ?", r"\1", rounded)
    return "".join(_polyline(part, digits) for part in re.findall(r"M[^M]*", data))


def _polyline(data: str, digits: int) -> str:
    closed = data.rstrip().endswith(("z", "Z"))
    numbers = [float(one) for one in re.findall(r"-?[\d.]+(?:e-?\d+)?", data)]
    points = _simplified(list(zip(numbers[::2], numbers[1::2], strict=True)))
    texts = [f"{_short(f'{x:.6f}', digits)} {_short(f'{y:.6f}', digits)}" for x, y in points]
    lines = [text for i, text in enumerate(texts) if not i or text != texts[i - 1]] or texts
    lines = lines if len(lines) > 1 or len(texts) == 1 else texts[:2]
    return "M" + "L".join(lines) + ("z" if closed else "")


def _simplified(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Ramer, Douglas and Peucker: no point left out is farther than SEEN_PX from the line."""
    keep, spans = {0, len(points) - 1}, [(0, len(points) - 1)]
    while spans:
        first, last = spans.pop()
        (ax, ay), (bx, by) = points[first], points[last]
        dx, dy = bx - ax, by - ay
        square = dx * dx + dy * dy
        farthest, worst = first, SEEN_PX**2
        for i in range(first + 1, last):
            px, py = points[i][0] - ax, points[i][1] - ay
            along = min(1.0, max(0.0, (px * dx + py * dy) / square)) if square > 0.0 else 0.0
            off = (px - along * dx) ** 2 + (py - along * dy) ** 2
            if off > worst:
                farthest, worst = i, off
        if farthest > first:
            keep.add(farthest)
            spans += [(first, farthest), (farthest, last)]
    return [points[i] for i in sorted(keep)]


def _shared_style(match: re.Match[str]) -> str:
    """Markers of one style say it once, for the group."""
    styles = set(STYLE.findall(match[2]))
    uses = re.findall(r"<use [^>]*/>", match[2])
    if len(styles) != 1 or len(uses) < 2:
        return match[0]
    return (
        f'<g{match[1] or ""} style="{styles.pop()}">' + "\n".join(STYLE.sub("", use) for use in uses) + "</g>"
    )
