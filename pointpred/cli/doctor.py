"""``pointpred doctor``: what works on this machine, what does not, and what to do next."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from contextlib import closing
from importlib.metadata import entry_points
from importlib.util import find_spec
from pathlib import Path
from typing import Literal

import msgspec
import typer

from pointpred import compiled
from pointpred.cli.output_files import AsJson, print_json
from pointpred.console import counted, results, table
from pointpred.errors import PointpredError, SourceError
from pointpred.extras import EXTRAS, absent, install_command

OLDEST = (3, 11)


class Finding(msgspec.Struct, frozen=True):
    """One thing that was looked at. ``missing`` is not needed by everybody, ``broken`` is by all."""

    name: str
    state: Literal["good", "missing", "broken"]
    found: str
    advice: str | None = None


def doctor(as_json: AsJson = False) -> None:
    """Check the installation: what works, what is missing, and what to do about it.

    Exits with 1 when something essential is broken, otherwise with 0.

    Try:

      pointpred doctor

      pointpred doctor --json | jq '.findings[] | select(.state != "good")'
    """
    findings = [finding for check in CHECKS for finding in run_check(check)]
    broken = [one for one in findings if one.state == "broken"]
    if as_json:
        print_json("findings", findings)
    else:
        show(findings)
    raise typer.Exit(1 if broken else 0)


def show(findings: list[Finding]) -> None:
    """Print a table; advice with lines to copy stands below it, where nothing wraps them."""
    below = [one for one in findings if one.advice and "\n" in one.advice]
    rows: list[tuple[str, str, str]] = []
    for one in findings:
        rows.append((one.state, one.name, one.found))
        if one.advice:
            rows.append(("", "", "-> see below" if one in below else f"-> {one.advice}"))
    results().print(table((), rows))
    for one in below:
        results().print(f"\n{one.name}: {one.advice}", soft_wrap=True)


def run_check(check: Callable[[], list[Finding]]) -> list[Finding]:
    """What a look finds; one that fails is itself a finding."""
    try:
        return check()
    except (PointpredError, OSError, ImportError) as error:
        return [Finding(check.__name__, "broken", f"{type(error).__name__}: {error}", "report this line")]


def python() -> list[Finding]:
    """The interpreter."""
    words = f"{sys.version.split()[0]} at {sys.executable}"
    if sys.version_info < OLDEST:
        return [Finding("python", "broken", words, "install pointpred under Python 3.11 or later")]
    return [Finding("python", "good", words)]


def laws() -> list[Finding]:
    """Whether laws are compiled, and one prediction as a proof that they run."""
    from pointpred import PointerEvent, build

    pipeline = build("hold")
    pipeline.update(PointerEvent(0.0, 0.0, 0.0))
    answer = pipeline.update(PointerEvent(0.01, 1.0, 0.0))
    if answer is None:
        return [Finding("prediction", "broken", "none was made where one is due", "install pointpred anew")]
    findings = [Finding("prediction", "good", "one was made")]
    if compiled.COMPILED:
        return [*findings, Finding("laws", "good", "compiled")]
    chosen = os.environ.get("POINTPRED_COMPILED") == "0"
    advice = "unset POINTPRED_COMPILED" if chosen else "install a C compiler, then install pointpred again"
    return [*findings, Finding("laws", "missing", "run as plain Python, much slower", advice)]


def extras() -> list[Finding]:
    """Optional libraries, and the distribution of observers."""
    findings = []
    for extra, modules in EXTRAS.items():
        if missing := absent(extra):
            advice = f"if you need them: {install_command(extra)}"
            findings.append(Finding(f"extra {extra}", "missing", f"without {', '.join(missing)}", advice))
        else:
            findings.append(Finding(f"extra {extra}", "good", ", ".join(modules)))
    if find_spec("pointpred_observers") is None:
        advice = f"if you need observers or the camera: {install_command(of='pointpred-observers')}"
        findings.append(Finding("pointpred-observers", "missing", "not installed", advice))
    else:
        findings.append(Finding("pointpred-observers", "good", "observers, camera"))
    return findings


def devices() -> list[Finding]:
    """Mice by both ways of reading them."""
    from pointpred.devices.evdev import list_evdev
    from pointpred.devices.hidraw import list_hid

    findings = []
    if sys.platform != "linux":
        return [Finding("mice", "good", "not read on this system: 'pointpred live' follows the cursor")]
    for kind, list_kind in (("hidraw", list_hid), ("evdev", list_evdev)):
        name = f"mice, {kind}"
        try:
            mice = list_kind()
        except SourceError as error:
            findings.append(Finding(name, "missing", "cannot be listed", str(error)))
            continue
        closed = [one for one in mice if not one.openable]
        words = f"{counted(len(mice), 'mouse' if len(mice) == 1 else 'device')}, {len(closed)} closed"
        if not mice:
            advice = "plug one in; virtual machines and containers have none of their own"
            findings.append(Finding(name, "missing", "none found", advice))
        elif len(closed) == len(mice):
            advice = closed[0].advice or "see 'pointpred devices list'"
            findings.append(Finding(name, "missing", f"{words}: {closed[0].why}", advice))
        else:
            findings.append(Finding(name, "good", words))
    return findings


def cursor() -> list[Finding]:
    """The screen's cursor."""
    from pointpred.devices.screen_cursor import RATE_HZ, UNTRIED, system_cursor

    try:
        with closing(system_cursor()) as screen:
            x, y = screen.position()
            words = f"at {x:g}, {y:g} of {screen.size[0]} x {screen.size[1]}: {screen.words}"
            if sys.platform in UNTRIED:
                words += f"; looked at {RATE_HZ:g} times a second; untested on this platform"
            return [Finding("cursor", "good", words)]
    except SourceError as error:
        return [Finding("cursor", "missing", "cannot be followed", str(error))]


def folders() -> list[Finding]:
    """Folders that the environment names."""
    findings = []
    for variable, need, use in (
        ("POINTPRED_RECORDINGS", os.R_OK, "recordings for tests and training"),
        ("POINTPRED_RECORD", os.W_OK, "what the service records"),
    ):
        name, value = f"folder, {use}", os.environ.get(variable)
        if not value:
            findings.append(Finding(name, "good", f"{variable} is not set: none is used"))
        elif not os.access(value, need | os.X_OK) or not Path(value).is_dir():
            verb = "read" if need == os.R_OK else "written"
            advice = f"set {variable} to a folder of yours, or unset it"
            findings.append(Finding(name, "broken", f"{value} is not a folder that can be {verb}", advice))
        else:
            findings.append(Finding(name, "good", value))
    return findings


def predictors() -> list[Finding]:
    """Predictors of other packages."""
    from pointpred.registry import load, others, package_of

    findings = []
    for name, found in others().items():
        try:
            load(name)
            findings.append(Finding(f"predictor {name}", "good", package_of(found)))
        except PointpredError as error:
            advice = f"repair or uninstall it; 'pointpred predictors {name}' says more"
            findings.append(Finding(f"predictor {name}", "broken", str(error), advice))
    return findings


def distributions() -> list[Finding]:
    """What the distributions installed beside this one look at."""
    return [
        finding
        for entry in sorted(entry_points(group="pointpred.checks"))
        for finding in run_check(entry.load())
    ]


CHECKS = (python, laws, extras, devices, cursor, folders, predictors, distributions)
"""In the order in which one thing builds on another."""
