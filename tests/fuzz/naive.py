"""A second reading of report descriptors, bit by bit: slow, and it shares nothing with ours."""

from __future__ import annotations

WANTED = {
    (0x01, 0x30): "x",
    (0x01, 0x31): "y",
    (0x01, 0x38): "wheel",
    (0x0C, 0x238): "pan",
    **{(0x09, number): f"button {number}" for number in range(1, 6)},
}
W3C = {"button 1": 1, "button 2": 2, "button 3": 4, "button 4": 8, "button 5": 16}
Place = tuple[int, int, bool]
"""First bit, bits, signed."""


def items(data: bytes) -> list[tuple[int, bytes]]:
    """Prefix (without its size) and data of each item; long items left out."""
    out, rest = [], data
    while rest:
        if rest[0] == 0xFE:
            rest = rest[3 + rest[1] :]
            continue
        size = [0, 1, 2, 4][rest[0] % 4]
        out.append((rest[0] - rest[0] % 4, rest[1 : 1 + size]))
        rest = rest[1 + size :]
    return out


def places(data: bytes) -> dict[int, dict[str, Place]]:
    """By report ID, where each wanted usage lies: the first field that has it."""
    state = {"page": 0, "minimum": 0, "size": 0, "count": 0, "id": 0}
    stack: list[dict[str, int]] = []
    usages: list[list[int]] = []  # page, usage, whether the item carried the page
    lowest: list[int] | None = None
    delimiters = 0
    found: dict[int, dict[str, Place]] = {}
    ends: dict[int, int] = {}
    numbered = False
    for prefix, raw in items(data):
        value = int.from_bytes(raw, "little")
        usage = [value >> 16, value & 0xFFFF, 1] if len(raw) == 4 else [state["page"], value, 0]
        if prefix == 0x04:
            state["page"] = value & 0xFFFF
        elif prefix == 0x14:
            state["minimum"] = int.from_bytes(raw, "little", signed=True)
        elif prefix == 0x74:
            state["size"] = value
        elif prefix == 0x84:
            state["id"], numbered = value, True
        elif prefix == 0x94:
            state["count"] = value
        elif prefix == 0xA4:
            stack.append(dict(state))
        elif prefix == 0xB4:
            state = stack.pop()
        elif prefix == 0xA8:
            delimiters += value != 0
        elif prefix == 0x08 and delimiters < 2:
            usages.append(usage)
        elif prefix == 0x18 and delimiters < 2:
            lowest = usage
        elif prefix == 0x28 and delimiters < 2 and lowest is not None:
            usages += [[lowest[0], number, lowest[2]] for number in range(lowest[1], usage[1] + 1)]
            lowest = None
        elif prefix % 16 == 0:
            if prefix == 0x80:
                at = ends.get(state["id"], 8 if state["id"] else 0)
                kept = _late(usages, state["page"]) if value & 3 == 2 else []
                for index in range(state["count"] if kept else 0):
                    page, number, _ = kept[min(index, len(kept) - 1)]
                    name = WANTED.get((page, number), "")
                    bits, first = state["size"], at + index * state["size"]
                    button = name.startswith("button")
                    if not name or not 0 < bits <= 32 or (button and bits > 1) or not (button or value & 4):
                        continue
                    signed = state["minimum"] < 0 and not button
                    found.setdefault(state["id"], {}).setdefault(name, (first, bits, signed))
                ends[state["id"]] = at + state["count"] * state["size"]
            usages, lowest, delimiters = [], None, 0
    if numbered:
        found.pop(0, None)
    return found


def _late(usages: list[list[int]], page: int) -> list[list[int]]:
    """The usages at a main item: trailing ones of one older page that did not carry it have the page now."""
    out = [list(usage) for usage in usages]
    stale = out[-1][0] if out else page
    for usage in reversed(out):
        if usage[2] or usage[0] != stale:
            break
        usage[0] = page
    return out


def read(place: Place, report: bytes) -> int:
    """A field's value, bit by bit."""
    first, bits, signed = place
    value = 0
    for index in range(bits):
        byte, bit = divmod(first + index, 8)
        if report[byte] // 2**bit % 2:
            value += 2**index
    return value - 2**bits if signed and value >= 2 ** (bits - 1) else value
