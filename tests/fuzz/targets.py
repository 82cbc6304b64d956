"""Every parser that reads what others wrote, as a fuzzer gives it bytes: the one table of targets.

A parser ends in a result or in a PointpredError with a message; settings in pydantic's error.
Each ``check`` raises whatever else happens, and AssertionError where a result is not in order.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

from pointpred.recordings.known_formats import FORMATS
from tests.fuzz import designs, evdev, files, hid, person, session, settings, transfer


class Target(NamedTuple):
    """One parser: what reads an input and says what came of it, inputs to begin with, and the code it runs.

    ``modules``: prefixes of the modules whose coverage guides the fuzzer.
    """

    name: str
    check: Callable[[bytes], str]
    seeds: Callable[[], list[bytes]]
    modules: tuple[str, ...]
    most_bytes: int = 4096


PROTOCOL = ("pointpred.protocol", "pointpred_server.sessions")
TARGETS = {
    target.name: target
    for target in (
        Target("hid", hid.check, hid.seeds, ("pointpred.devices.hid",), 600),
        Target("evdev", evdev.check, evdev.seeds, ("pointpred.devices.evdev",)),
        Target("messages", session.check_message, session.message_seeds, ("pointpred.protocol",)),
        Target("session", session.check_session, session.session_seeds, PROTOCOL),
        Target(
            "client", session.check_client, session.client_seeds, ("pointpred.protocol", "pointpred.client")
        ),
        Target("person", person.check, person.seeds, ("pointpred.person",)),
        Target(
            "coefficients",
            files.check_coefficients,
            files.coefficient_seeds,
            ("pointpred.predictors.kinematic.coefficient_file",),
            8192,
        ),
        Target("designs", designs.check, designs.seeds, ("pointpred_observers.documents",), 8192),
        Target("transfer", transfer.check, transfer.seeds, ("pointpred.transfer",)),
        Target(
            "settings",
            settings.check,
            settings.seeds,
            ("pointpred_server.settings", "pointpred_server.access"),
        ),
        *(
            Target(
                f"source-{form.key}",
                partial(files.check_source, form),
                partial(files.source_seeds, form),
                ("pointpred.recordings", "pyxdf") if form.key == "xdf" else ("pointpred.recordings",),
                8192,
            )
            for form in FORMATS
        ),
    )
}
