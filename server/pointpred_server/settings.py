"""Settings of the service: by environment (``POINTPRED_...``) or by the flags of ``pointpred serve``."""

from __future__ import annotations

import json
import os
import re
import secrets
from collections.abc import Iterable
from difflib import get_close_matches
from ipaddress import ip_address, ip_network
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, PrivateAttr, field_validator, model_validator
from pydantic_settings import BaseSettings, NoDecode, SettingsConfigDict

from pointpred.predictors.kinematic import coefficient_file
from pointpred.protocol.server_messages import Limits
from pointpred_server.access import is_address, is_origin


def _parts(value: Any) -> Any:
    """A list from a text with commas, as an environment has it."""
    return [part.strip() for part in value.split(",") if part.strip()] if isinstance(value, str) else value


NAME = re.compile(r"[A-Za-z0-9_-]+(\.[A-Za-z0-9_-]+)*")
FILE_NAME = re.compile(r"[A-Za-z0-9_-]{1,64}")
Words = Annotated[tuple[str, ...], NoDecode, BeforeValidator(_parts)]


def named_files(parts: Iterable[str]) -> dict[str, Path]:
    """The files of ``NAME=FILE``, each name once; raises ValueError."""
    files: dict[str, Path] = {}
    for part in parts:
        name, equals, file = part.partition("=")
        if not (name and equals and file) or name in files:
            raise ValueError(f"needs NAME=FILE, each with a name of its own, received {part!r}")
        files[name] = Path(file)
    return files


def _files(value: Any) -> Any:
    """Files by name: from flags, and from an environment as ``a=x,b=y`` or as a JSON object."""
    if isinstance(value, str) and value.lstrip().startswith("{"):
        return json.loads(value)  # its error is a ValueError
    parts = _parts(value)
    return named_files(parts) if isinstance(parts, list) else parts


Files = Annotated[dict[str, Path], NoDecode, BeforeValidator(_files)]


ELSEWHERE = frozenset({"COMPILED", "RECORDINGS", "DEBUG"})
"""What else the environment may say to pointpred, after ``POINTPRED_``."""


class Settings(BaseSettings):
    """What a service is started with."""

    model_config = SettingsConfigDict(env_prefix="POINTPRED_", extra="ignore", frozen=True)

    host: str = Field(default="127.0.0.1", description="Address to listen on.")
    port: int | None = Field(
        default=None,
        ge=0,
        le=65535,
        description="Port; 0 takes any free one. Not given: the first free from 8765.",
    )
    metrics_port: int | None = Field(
        default=None,
        ge=0,
        le=65535,
        description="Port of 127.0.0.1 with metrics for Prometheus; 0 takes any free one. Not given: none.",
    )
    allow_host: Words = Field(default=(), description="Other host names this service answers to.")
    allow_origin: Words = Field(default=(), description="Origins of other sites' pages that may connect.")
    trust_proxy: Words = Field(
        default=(),
        description="Addresses of reverse proxies that say whom they ask for: 127.0.0.1, 10.0.0.0/8.",
    )
    token: str | None = Field(
        default=None,
        min_length=8,
        description="Secret that clients must send; generated when other machines can reach the service.",
    )
    record: Path | None = Field(
        default=None, description="Folder in which sessions are recorded; not given: nothing is recorded."
    )
    coefficients: Files = Field(
        default={},
        description="Files of 'pointpred train' by the names that clients may ask for: me=/path/me.npz.",
    )
    log_format: Literal["json", "text"] | None = Field(
        default=None,
        description="Format of log entries; not given: text in a terminal, json elsewhere.",
    )
    max_sessions: int = Field(default=64, ge=1, le=100_000, description="Most sessions at a time.")
    max_per_address: int | None = Field(
        default=None,
        ge=1,
        le=100_000,
        description="Most sessions of one other machine; of IPv6, of one /64 network. "
        "Not given: half of POINTPRED_MAX_SESSIONS. Those of this machine have no share of their own.",
    )
    max_events_per_s: int = Field(
        default=20_000, ge=1, le=10**8, description="Most events a second in one session."
    )
    max_frame_bytes: int = Field(default=65_536, ge=1024, le=900_000, description="Most bytes in one frame.")
    max_targets: int = Field(default=256, ge=0, le=10**5, description="Most targets in one session.")
    idle_s: float = Field(
        default=60.0, gt=0.0, le=1e6, description="Seconds without a frame until a session ends."
    )
    _token_made_up: bool = PrivateAttr(default=False)

    @field_validator("record", mode="before")
    @classmethod
    def _folder(cls, folder: object) -> object:
        """An empty variable of a compose file would record into the current folder."""
        if folder == "":
            raise ValueError("name a folder to record in, or leave it away to record nothing")
        return folder

    @field_validator("allow_host")
    @classmethod
    def _hosts(cls, hosts: tuple[str, ...]) -> tuple[str, ...]:
        """Names as a ``Host`` header has them, without the port: another spelling would never be met."""
        for host in hosts:
            if not (NAME.fullmatch(host) or is_address(host)):
                raise ValueError(
                    f"a host reads like lab.example, several like a.example,b.example; received {host!r}"
                )
        return hosts

    @field_validator("allow_origin")
    @classmethod
    def _origins(cls, origins: tuple[str, ...]) -> tuple[str, ...]:
        """Origins as browsers write them: another spelling would never be met."""
        for origin in origins:
            if not is_origin(origin):
                raise ValueError(f"an origin reads like https://lab.example:8000, received {origin!r}")
        return origins

    @field_validator("trust_proxy")
    @classmethod
    def _proxies(cls, proxies: tuple[str, ...]) -> tuple[str, ...]:
        """Addresses or networks: a name would have to be looked up for each connection."""
        for proxy in proxies:
            try:
                ip_network(proxy)
            except ValueError as error:
                raise ValueError(
                    f"a proxy is an address or a network such as 127.0.0.1 or 10.0.0.0/8: {error}"
                ) from None
        return proxies

    @field_validator("coefficients")
    @classmethod
    def _coefficients(cls, files: dict[str, Path]) -> dict[str, Path]:
        """Each file is read now: a wrong one is an error at the start, not in a session."""
        for name, file in files.items():
            if not FILE_NAME.fullmatch(name):
                raise ValueError(f"a name of coefficients has 1 to 64 of A-Z a-z 0-9 _ -; received {name!r}")
            coefficient_file.read(file)
            coefficient_file.sets(file)
        return {name: file.absolute() for name, file in files.items()}

    @model_validator(mode="after")
    def _environment(self) -> Settings:
        """A misspelt token would leave a service open: what nobody reads is an error."""
        names = {name.upper() for name in type(self).model_fields}
        for variable in os.environ:
            prefix, _, name = variable.partition("_")
            if prefix.upper() == "POINTPRED" and name.upper() not in names | ELSEWHERE:
                near = get_close_matches(name.upper(), names, 1)
                nearest = f"; the nearest is POINTPRED_{near[0]}" if near else ""
                raise ValueError(f"unknown variable {variable} in the environment{nearest}")
        return self

    @property
    def limits(self) -> Limits:
        """What a session may do."""
        return Limits(**self.model_dump(include=set(Limits.__struct_fields__)))

    @property
    def share(self) -> int:
        """Most sessions of one other machine."""
        given = self.max_per_address
        return max(1, self.max_sessions // 2) if given is None else given

    def guarded(self) -> Settings:
        """The same, with a token made up where other machines can reach it, directly or by a proxy."""
        if self.token is not None or (is_loopback(self.host) and not self.trust_proxy):
            return self
        guarded = self.model_copy(update={"token": secrets.token_urlsafe(24)})
        guarded._token_made_up = True
        return guarded

    @property
    def address_query(self) -> str:
        """The end of the address that is printed: a token made up here, which nobody knows yet."""
        return f"?token={self.token}" if self._token_made_up else ""

    def printable(self) -> dict[str, object]:
        """Every setting, the token masked: printed on start."""
        shown = self.model_dump(mode="json")
        return {**shown, "token": None if self.token is None else "***"}


def is_loopback(host: str) -> bool:
    """Whether only this machine can reach an address."""
    if host == "localhost":
        return True
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return False
