"""The person file of a session: read at the start and written at the end."""

from __future__ import annotations

import os
from pathlib import Path

from pointpred.errors import ParameterError
from pointpred.files import beside
from pointpred.person import LARGEST, portable
from pointpred.pipeline import Pipeline
from pointpred.registry import REGISTRY, build


def read_person(file: Path | None, predictor: str) -> str:
    """The person in a file; "" if there is no file yet, or none was named.

    Raises ParameterError for a predictor without one, and for a file that holds none of this predictor.
    """
    if file is None:
        return ""
    if str(file) == "-" or not portable(build(predictor).predictor):
        able = ", ".join(name for name in REGISTRY if portable(build(name).predictor))
        raise ParameterError(f"--person needs a file and one of {able}, received {file} and {predictor}")
    if not file.exists():
        return ""
    with file.open("rb") as opened:
        person = opened.read(LARGEST + 2).decode("ascii", errors="replace").strip()
    try:
        build(predictor, person=person)
    except ParameterError as error:
        raise ParameterError(f"--person {file}: {error}") from None
    return person


def save_person(file: Path, pipeline: Pipeline) -> str:
    """Finish the movement and write the person, readable by the owner only; returns a message."""
    pipeline.reset()
    if not pipeline.person:
        return "nothing was learned, nothing saved"
    part = beside(file, "part")
    try:
        with os.fdopen(os.open(part, os.O_CREAT | os.O_WRONLY | os.O_TRUNC, 0o600), "wb") as opened:
            opened.write(f"{pipeline.person}\n".encode())
        part.replace(file)
    finally:
        part.unlink(missing_ok=True)
    return f"saved in {file}"
