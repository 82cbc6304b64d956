"""``/v1/live``: who may look at the attached device, and what is said where there is none."""

from __future__ import annotations

import asyncio
import logging

from uvicorn.protocols.utils import ClientDisconnected

from pointpred.protocol.server_messages import ErrorMessage, encode
from pointpred.server.connections.talk import Receive, Send, Talk
from pointpred.server.endpoint import Scope, StreamEndpoint, shows_token, turn_away
from pointpred.server.hosts import admits_origin
from pointpred.server.live.feed import LiveFeed
from pointpred.server.logs import place_of
from pointpred.server.sessions.conversation import FAILED

log = logging.getLogger("pointpred.service")

NO_DEVICE = (
    "no device is attached; to show a mouse here, run 'pointpred live --serve' "
    "on the machine it is plugged into"
)


class LiveEndpoint(StreamEndpoint):
    """An ASGI application for viewers; the same origins, token and limits as for sessions."""

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Refuse foreign origins, then everybody where nothing is attached, then as for sessions."""
        try:
            await receive()  # websocket.connect
            if self._nothing_to_show(scope):
                self.service.metrics.turned_away.labels("out_of_place").inc()
                await _not_here(scope, send)
            elif await self._admitted(scope, send) and (feed := self.service.live) is not None:
                await self._show(feed, receive, send)
        except ClientDisconnected:
            pass  # it left before it saw anything

    def _nothing_to_show(self, scope: Scope) -> bool:
        """Whether to say that no device is attached, which only those hear who may connect."""
        settings = self.service.settings
        return (
            self.service.live is None
            and admits_origin(scope, settings.allow_origin)
            and shows_token(scope, settings.token)
        )

    async def _show(self, feed: LiveFeed, receive: Receive, send: Send) -> None:
        service = self.service
        viewer = service.view(asyncio.get_running_loop().time())
        try:
            talk = Talk(
                viewer, receive, send, lambda seconds: None
            )  # nothing it says is a prediction's cause
            service.attach(viewer, talk)
            feed.join(viewer, talk.wake)
            await talk.run()
        except ClientDisconnected:
            pass  # it went away while something was sent
        except Exception as error:  # whatever it is, the process and the others go on
            log.error("a viewer failed", extra={"session": viewer.name, "error": place_of(error)})
            viewer.fail()
            await turn_away(send, "internal", FAILED, 1011)
        finally:
            feed.leave(viewer)
            viewer.lose()
            service.closed(viewer)


async def _not_here(scope: Scope, send: Send) -> None:
    """404 before the upgrade, with the words in it where the server can send them."""
    if "websocket.http.response" not in scope.get("extensions", {}):
        await send({"type": "websocket.close", "code": 1008})
        return
    said = encode(ErrorMessage("out_of_place", NO_DEVICE, None))
    headers = [(b"content-type", b"application/json"), (b"content-length", str(len(said)).encode())]
    await send({"type": "websocket.http.response.start", "status": 404, "headers": headers})
    await send({"type": "websocket.http.response.body", "body": said})
