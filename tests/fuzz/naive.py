"""A second reading of report descriptors, bit by bit: slow, and it shares nothing with ours."""

from __future__ import annotations

WANTED = {
    (0x01, 0x30): "x",
    (0x01, 0x31): "y",
    (0x01, 0x38): "wheel",
    (0x0C, 0x238): "pan",
    **{(0x09, number): f"button {number}" for number in range(1, 6)},
}
SURFACE = {
    (0x01, 0x30): "x",
    (0x01, 0x31): "y",
    (0x0D, 0x42): "tip",
    (0x0D, 0x32): "in range",
    (0x0D, 0x44): "barrel",
    (0x0D, 0x51): "contact",
}
POINTERS = [(1, 1), (1, 2), *((0x0D, number) for number in (1, 2, 3, 4, 6, 12))]
W3C = {"button 1": 1, "button 2": 2, "button 3": 4, "button 4": 8, "button 5": 16}
Place = tuple[int, int, bool]
"""First bit, bits, signed."""
Contact = dict[str, tuple[int, ...]]
"""Of each absolute usage: first bit, bits, signed, least, most, whether a value outside says nothing."""


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


def places(data: bytes) -> tuple[dict[int, dict[str, Place]], dict[int, list[Contact]]]:
    """By report ID, where each wanted usage lies, the first field that has it: relative and absolute ones."""
    state = {"page": 0, "minimum": 0, "maximum": 0, "size": 0, "count": 0, "id": 0}
    opened: list[tuple[int, tuple[int, int], int]] = []
    ever = 0
    surfaces: dict[int, dict[int, Contact]] = {}
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
        elif prefix == 0x24:
            state["maximum"] = int.from_bytes(raw, "little", signed=state["minimum"] < 0)
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
            if prefix == 0xA0:
                of = _late(usages, state["page"])
                ever += 1
                opened.append((value, (of[0][0], of[0][1]) if of else (0, 0), ever))
            elif prefix == 0xC0:
                opened.pop()
            if prefix == 0x80:
                levels = [level for level, each in enumerate(opened) if each[0] == 1]
                application = opened[levels[-1]][1] if levels else None
                inside = opened[levels[-1] + 1][2] if levels and len(opened) > levels[-1] + 1 else 0
                at = ends.get(state["id"], 8 if state["id"] else 0)
                kept = _late(usages, state["page"]) if value & 3 == 2 else []
                for index in range(state["count"] if kept else 0):
                    page, number, _ = kept[min(index, len(kept) - 1)]
                    name = WANTED.get((page, number), "")
                    bits, first = state["size"], at + index * state["size"]
                    absolute = SURFACE.get((page, number), "")
                    if absolute and not value & 4 and 0 < bits <= 32 and application in POINTERS:
                        low, high = state["minimum"], state["maximum"]
                        if low < high if absolute in "xy" else bits == 1 or absolute == "contact":
                            field = (first, bits, low < 0, low, high, value & 64)
                            group = surfaces.setdefault(state["id"], {}).setdefault(inside, {})
                            group.setdefault(absolute, field)
                    button = name.startswith("button")
                    if not name or not 0 < bits <= 32 or (button and bits > 1) or not (button or value & 4):
                        continue
                    signed = state["minimum"] < 0 and not button
                    found.setdefault(state["id"], {}).setdefault(name, (first, bits, signed))
                ends[state["id"]] = at + state["count"] * state["size"]
            usages, lowest, delimiters = [], None, 0
    if numbered:
        found.pop(0, None)
        surfaces.pop(0, None)
    contacts: dict[int, list[Contact]] = {}
    for number, groups in surfaces.items():
        shared = groups.get(0, {})
        some = [{**shared, **group} for group in groups.values() if {"x", "y"} <= group.keys()]
        if some and not {"x", "y"} & found.get(number, {}).keys():
            contacts[number] = some
            barrels = [group["barrel"] for group in groups.values() if "barrel" in group]
            some[0] |= {"any barrel": min(barrels)} if barrels else {}
            found.setdefault(number, {})
    return found, contacts


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
