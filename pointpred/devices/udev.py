"""Rules for udev that give access to mice to the user at the screen only."""

from __future__ import annotations

from pathlib import Path

RULES_FILE = "/etc/udev/rules.d/70-pointpred.rules"
"""Below 73, where systemd reads the tag."""
RELOAD = "sudo udevadm control --reload && sudo udevadm trigger"
SHIPPED = Path(__file__).with_name("70-pointpred.rules")


def hid_rule(vendor: int, product: int, mouse_interface: bool = False) -> str:
    """The line for one HID device.

    ``mouse_interface``: its USB interface says that it is a mouse, and only that interface is opened.
    Otherwise every interface of the device is, by USB or Bluetooth, a keyboard's of the same receiver too:
    the kernel names devices bus:vendor:product.number.

    >>> hid_rule(0x46D, 0xC077)
    'KERNEL=="hidraw*", SUBSYSTEM=="hidraw", KERNELS=="*:046D:C077.*", TAG+="uaccess"'
    """
    which = f'KERNELS=="*:{vendor:04X}:{product:04X}.*"'
    if mouse_interface:
        which = f'ATTRS{{modalias}}=="usb:v{vendor:04X}p{product:04X}*", ATTRS{{bInterfaceProtocol}}=="02"'
    return f'KERNEL=="hidraw*", SUBSYSTEM=="hidraw", {which}, TAG+="uaccess"'


def permission_advice(rule: str) -> str:
    """What to do where a node may not be opened: a sentence, and lines to copy, which must not be wrapped."""
    return (
        f"put this line into {RULES_FILE}:\n  {rule}\n"
        "or let these two commands write rules for every mouse here and load them, then plug it in again:\n"
        f"  pointpred devices udev | sudo tee {RULES_FILE}\n  {RELOAD}"
    )


def shipped_rules() -> str:
    """The rules of the package: USB interfaces that say they are mice, and input nodes of mice."""
    return SHIPPED.read_text(encoding="utf-8")
