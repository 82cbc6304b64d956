"""How many HTTP requests another machine may send: many at once, fewer in the long run."""

from __future__ import annotations

from collections.abc import Iterable
from ipaddress import ip_address, ip_network

from pointpred_server.access import network_of

REQUESTS_PER_S = 200
"""Requests of one other machine in the long run; those for a WebSocket are among them."""
REQUESTS_AT_ONCE = 10_000
"""Requests of one other machine at once: sixty people behind one address may load the page, with 161 each."""


class RequestRates:
    """The requests of each network lately, so that one does not take all of the processor.

    Requests of this machine and of trusted proxies are not counted: they may be those of everybody.
    Memory grows with the networks that sent requests within two minutes.
    """

    def __init__(self, proxies: Iterable[str] = ()) -> None:
        """``proxies``: addresses or networks."""
        self._proxies = [ip_network(proxy) for proxy in proxies]
        self._full_at: dict[str, float] = {}  # when each network may again send as many at once as any
        self._removed_at = 0.0

    def counted_as(self, address: str) -> str | None:
        """The network by which requests of an address are counted; ``None`` where they are not."""
        try:
            parsed = ip_address(address)
        except ValueError:
            return None
        if parsed.is_loopback or any(parsed in proxy for proxy in self._proxies):
            return None
        return network_of(address)

    def take(self, network: str, now: float) -> bool:
        """Count one request; False, and nothing counted, where too many came."""
        fill_s = REQUESTS_AT_ONCE / REQUESTS_PER_S
        if now - self._removed_at > fill_s:
            self._full_at = {name: full_at for name, full_at in self._full_at.items() if full_at > now}
            self._removed_at = now
        full_at = max(self._full_at.get(network, now), now) + 1 / REQUESTS_PER_S
        if full_at > now + fill_s:
            return False
        self._full_at[network] = full_at
        return True
