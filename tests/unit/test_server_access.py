"""What decides who may connect, without a socket: odd names of hosts, and how a token is compared."""

from __future__ import annotations

import hmac
from typing import Any

import pytest

from pointpred.clock import Instant
from pointpred_server import access
from pointpred_server.access import HostRule, has_token, network_of
from pointpred_server.service import Refusal, Service
from pointpred_server.sessions.lifecycle import Session
from pointpred_server.settings import Settings

TOKEN = "a-token-of-24-characters"


def asked(host: str) -> dict[str, Any]:
    """A request to a host of that name."""
    return {"headers": [(b"host", host.encode("latin-1"))]}


def shown(token: str) -> list[dict[str, Any]]:
    """A token in the query, and one in the header."""
    return [
        {"query_string": b"token=" + token.encode(), "headers": []},
        {"query_string": b"", "headers": [(b"authorization", b"Bearer " + token.encode())]},
    ]


@pytest.mark.parametrize(
    "name", ["\xa0127.0.0.1", "127.0.0.1\x85", "\x1c[::1]:80", "local host", "localhost,localhost"]
)
def test_only_what_headers_may_stand_in_is_taken_from_a_name(name: str) -> None:
    assert not HostRule().admits(asked(name))
    assert HostRule().admits(asked(" 127.0.0.1\t"))


def test_a_token_is_compared_in_constant_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing but hmac's comparison admits: with one that refuses everything, the right token is refused."""
    assert access.compare_digest is hmac.compare_digest
    compared: list[tuple[bytes, bytes]] = []

    def refuse(one: bytes, other: bytes) -> bool:
        compared.append((one, other))
        return False

    assert all(has_token(scope, TOKEN) for scope in shown(TOKEN))
    monkeypatch.setattr(access, "compare_digest", refuse)
    for token in (TOKEN, TOKEN[:-1] + "x", "x" + TOKEN[1:], TOKEN[:3], "\xff"):
        for scope in shown(token):
            compared.clear()
            assert not has_token(scope, TOKEN)
            assert [other for _, other in compared] == [TOKEN.encode()]


@pytest.mark.parametrize(
    ("address", "network"),
    [
        ("192.0.2.7", "192.0.2.7"),
        ("::ffff:192.0.2.7", "192.0.2.7"),
        ("::ffff:127.0.0.1", "127.0.0.1"),
        ("2001:db8:1:2:3:4:5:6", "2001:db8:1:2::/64"),
        ("2001:DB8:1:2::", "2001:db8:1:2::/64"),
        ("fe80::1%eth0", "fe80::/64"),
        ("::1", "::1"),
        ("unknown", "unknown"),
    ],
)
def test_sessions_count_by_the_network_that_one_customer_has(address: str, network: str) -> None:
    assert network_of(address) == network


class Socket:
    """The socket of a session that nobody speaks over."""

    messages = 0

    def flush(self) -> None:
        """Nothing is sent."""

    def tick(self, at: Instant, late_s: float) -> None:
        """Nothing is due."""


def test_one_network_has_one_share_however_many_of_its_addresses_connect() -> None:
    service = Service(Settings(host="0.0.0.0", token=TOKEN, max_per_address=1))

    def opened(address: str) -> Session | Refusal:
        scope = {"path": "/v1/stream", "client": (address, 1), **shown(TOKEN)[0]}
        return service.open_session(scope, Socket())

    first, second, third = map(opened, ("2001:db8::1", "2001:db8::2", "2001:db8:0:1::1"))
    assert isinstance(first, Session)
    assert isinstance(second, Refusal)
    assert (second.code, second.close) == ("too_many", 1013)
    assert isinstance(third, Session)
    service.close_session(first)
    assert isinstance(opened("2001:db8::2"), Session)
    service.shut_down()


@pytest.mark.parametrize(
    ("peer", "forwarded", "client"),
    [
        ("127.0.0.1", "192.0.2.7", "192.0.2.7"),
        ("::ffff:127.0.0.1", "192.0.2.7", "192.0.2.7"),
        ("127.0.0.1", "198.51.100.1, 192.0.2.7", "192.0.2.7"),
        ("127.0.0.1", "192.0.2.7, 10.0.0.4", "192.0.2.7"),
        ("127.0.0.1", "192.0.2.7:4001", "192.0.2.7"),
        ("127.0.0.1", "[2001:db8::1]:4001", "2001:db8::1"),
        ("127.0.0.1", "[2001:db8::1]", "2001:db8::1"),
        ("127.0.0.1", "localhost", "127.0.0.1"),
        ("127.0.0.1", "", "127.0.0.1"),
        ("192.0.2.1", "192.0.2.7", "192.0.2.1"),
    ],
)
def test_a_client_is_who_the_nearest_trusted_proxy_says(peer: str, forwarded: str, client: str) -> None:
    """However it writes the address; what is none is the proxy's own, and so is another peer's word."""
    scope = {
        "client": (peer, 1),
        "scheme": "ws",
        "headers": [(b"x-forwarded-for", forwarded.encode()), (b"x-forwarded-proto", b"https")],
    }
    access.believe_proxy(scope, ["127.0.0.1", "10.0.0.0/8"])
    assert scope["client"][0] == client
    assert scope["scheme"] == ("ws" if peer == "192.0.2.1" else "https")
