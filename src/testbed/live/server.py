"""The server of the page: on this machine only, for those who know its token. The first browser flies, others look on."""

from __future__ import annotations

import asyncio
import contextlib
import hmac
import json
import secrets
import signal
import socket
from collections.abc import Callable
from http import HTTPStatus
from typing import Any
from urllib.parse import parse_qs, quote, urlsplit

from websockets.asyncio.server import ServerConnection, broadcast, serve
from websockets.datastructures import Headers
from websockets.exceptions import ConnectionClosed
from websockets.http11 import Request, Response
from websockets.typing import Origin

from testbed.inputs.problems import BadInput, Problem
from testbed.live.aloft import Aloft
from testbed.live.messages import MOST_BYTES, read

_HOST = "127.0.0.1"
_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
"""Each ends the server, but one that is ignored, as under nohup."""
_MOST_PAGES = 8
_MOST_WAITING_BYTES = 200_000
"""A page that has not taken this much yet is sent no frames, until it has."""
_LIVES_S = 10.0
"""How often a page is asked whether it is there, and how long it may take to answer."""
_HEADERS = {
    "Cache-Control": "no-store",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Cross-Origin-Resource-Policy": "same-origin",
}


def listening(port: int) -> socket.socket:
    """A socket of this machine's loopback at a port, any free one for 0; raises BadInput."""
    try:
        listener = socket.create_server((_HOST, port))
        # Else a short message waits 40 ms for the last one's receipt. asyncio asks for this only where a socket names TCP.
        listener.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return listener
    except (OSError, OverflowError) as error:
        why = getattr(error, "strerror", None) or str(error)
        what = f"port {port} cannot be had: {why}"
        raise BadInput([Problem(what, "--port", expected="a free one")]) from None


class LiveServer:
    """Gives browsers the page, the pilot's frames to all of them, and the messages of the first of them to the pilot."""

    _loop: asyncio.AbstractEventLoop

    def __init__(
        self, listener: socket.socket, page: Callable[[dict[str, Any], str], str], pilot: Aloft
    ) -> None:
        """`page` makes the page, given the pilot's facts and the address to which it connects."""
        self._listener, self._token = listener, secrets.token_urlsafe(24)
        port = listener.getsockname()[1]
        self._hosts = [f"{_HOST}:{port}", f"localhost:{port}"]
        self._page, self._pilot = page, pilot
        self.address = f"http://{self._hosts[0]}/?token={self._token}"
        self._here: list[ServerConnection] = []

    def run(self, ready: Callable[[], object]) -> None:
        """Serve until a signal ends it; `ready` is called once browsers can connect. Raises KeyboardInterrupt then."""
        asyncio.run(self._run(ready))
        raise KeyboardInterrupt

    async def _run(self, ready: Callable[[], object]) -> None:
        self._loop = asyncio.get_running_loop()
        ended = asyncio.Event()
        # A KeyboardInterrupt could come in the middle of a callback of asyncio's, which would then wait for ever for its end.
        heeded = [each for each in _SIGNALS if callable(signal.getsignal(each))]
        for number in heeded:
            self._loop.add_signal_handler(number, ended.set)
        async with serve(
            self._with_page,
            sock=self._listener,
            origins=[Origin(f"http://{host}") for host in self._hosts],
            process_request=self._answer,
            max_size=MOST_BYTES,
            max_queue=8,
            compression=None,
            open_timeout=_LIVES_S,
            close_timeout=1.0,
            ping_interval=_LIVES_S,
            ping_timeout=_LIVES_S,
            server_header=None,
        ):
            self._pilot.start(self._tell)
            try:
                ready()
                await ended.wait()
            finally:
                for number in heeded:  # another one does not wait
                    self._loop.remove_signal_handler(number)
                await asyncio.to_thread(self._pilot.end)

    # HTTP -----------------------------------------------------------------------------------------------------

    def _answer(self, connection: ServerConnection, request: Request) -> Response | None:
        """What a request gets: the page, a refusal, or None for a connection that is to be opened."""
        hosts = request.headers.get_all("Host")
        if len(hosts) != 1 or hosts[0] not in self._hosts:
            return _response(HTTPStatus.MISDIRECTED_REQUEST, "not the address of this server\n")
        try:
            address = urlsplit(request.path)
        except ValueError:
            return _response(HTTPStatus.BAD_REQUEST, "not an address\n")
        if address.path == "/favicon.ico":
            return _response(HTTPStatus.NO_CONTENT, "")
        given = parse_qs(address.query).get("token", [""])[-1]
        if not hmac.compare_digest(given.encode(), self._token.encode()):
            return _response(HTTPStatus.FORBIDDEN, "open the address that testbed live has printed\n")
        if address.path == "/":
            text = self._page(self._pilot.facts, f"ws://{hosts[0]}")
            return _response(HTTPStatus.OK, text, "text/html")
        if address.path == "/report.html":
            return self._report()
        if address.path == "/flight":
            return None
        return _response(HTTPStatus.NOT_FOUND, "there is nothing here\n")

    def _report(self) -> Response:
        """The report of what was saved last, as a file to keep: it replays the flight, and needs no other."""
        saved = self._pilot.last_saved
        with contextlib.suppress(OSError):
            if saved is not None and (data := (saved / "report.html").read_bytes()):
                answer = _response(HTTPStatus.OK, data, "text/html")
                answer.headers["Content-Disposition"] = f'attachment; filename="{quote(saved.name)}.html"'
                return answer
        return _response(HTTPStatus.NOT_FOUND, "no report has been saved\n")

    # Pages ----------------------------------------------------------------------------------------------------

    def _tell(self, what: bytes | dict[str, Any]) -> None:
        """Send a frame or a note to every page; from any thread."""
        with contextlib.suppress(RuntimeError):  # the server has ended
            self._loop.call_soon_threadsafe(self._send_all, what)

    def _send_all(self, what: bytes | dict[str, Any]) -> None:
        ready = self._here
        if isinstance(what, bytes):
            ready = [each for each in ready if each.transport.get_write_buffer_size() < _MOST_WAITING_BYTES]
        broadcast(ready, what if isinstance(what, bytes) else json.dumps(what))

    async def _with_page(self, connection: ServerConnection) -> None:
        if len(self._here) >= _MOST_PAGES:
            await connection.close(1013, "too many pages")
            return
        self._here.append(connection)
        try:
            self._roles()
            self._say(connection, self._pilot.state)
            async for text in connection:
                self._say(connection, await self._answered(connection, text))
        except ConnectionClosed:
            pass  # a browser that has gone
        finally:
            self._here.remove(connection)
            self._roles()

    def _roles(self) -> None:
        """Tell each page whether it flies or looks on, and the pilot whether there is one."""
        self._pilot.look(bool(self._here))
        for each in self._here:
            self._say(each, {"note": "role", "flies": each is self._here[0]})

    def _say(self, connection: ServerConnection, note: dict[str, Any]) -> None:
        broadcast([connection], json.dumps(note))

    async def _answered(self, connection: ServerConnection, text: str | bytes) -> dict[str, Any]:
        """Carry out a message; returns the answer."""
        number = None
        try:
            message = read(text)
            number = message.id
            if connection is not self._here[0]:
                raise BadInput([Problem("another page flies, this one looks on")])
            await asyncio.wrap_future(self._pilot.ask(message))
        except BadInput as error:
            return {"note": "refused", "id": number, "why": str(error)}
        return {"note": "done", "id": number}


def _response(status: HTTPStatus, body: str | bytes, kind: str = "text/plain") -> Response:
    data = body if isinstance(body, bytes) else body.encode()
    headers = {**_HEADERS, "Content-Type": f"{kind}; charset=utf-8", "Content-Length": str(len(data))}
    return Response(status.value, status.phrase, Headers(headers), data)
