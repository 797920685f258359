"""`gaitway ctl` ends within its time-out, whatever the server leaves undone, and a signal ends its walk."""
import base64
import hashlib
import json
import signal
import socket
import struct
import subprocess
import threading
import time
import unittest

from served_robot import COMMAND, until

NO_ANSWER = 3
TIMEOUT_S = 0.4
LATEST_S = 15.0  # of a busy computer


class Server:
    """Takes one connection; answers what `answers` names, service by service, and is silent about all else."""

    def __init__(self, shakes_hands=True, answers=(), chatters=False):
        self._shakes_hands, self._answers, self._chatters = shakes_hands, answers, chatters
        self.called = []
        self._socket = socket.create_server(("127.0.0.1", 0))
        self.port = self._socket.getsockname()[1]
        self._done = threading.Event()
        self._thread = threading.Thread(target=self._serve, daemon=True)

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._done.set()
        self._socket.shutdown(socket.SHUT_RDWR)
        self._socket.close()
        self._thread.join()

    def _serve(self):
        try:
            with self._socket.accept()[0] as connection:
                try:
                    if self._shakes_hands:
                        self._talk(connection)
                except (ConnectionError, EOFError):
                    pass
                self._done.wait()  # open, and silent
        except OSError:
            pass  # nobody came

    def _talk(self, connection):
        head = b""
        while not head.endswith(b"\r\n\r\n"):
            head += self._bytes(connection, 1)
        key = next(line.split(b":")[1].strip() for line in head.split(b"\r\n") if line.lower().startswith(b"sec-websocket-key"))
        accept = base64.b64encode(hashlib.sha1(key + b"258EAFA5-E914-47DA-95CA-C5AB0DC85B11").digest())
        connection.sendall(b"HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                           b"Sec-WebSocket-Accept: " + accept + b"\r\n\r\n")
        while True:
            message = self._message(connection)
            service = message.get("service")
            if service:
                self.called.append(service)
            if service in self._answers:
                self._send(connection, {"op": "service_response", "id": message["id"], "result": True,
                                        "values": {"success": True, "message": "done", "lease": "1"}})
            while self._chatters and not self._done.is_set():
                self._send(connection, {"op": "status", "level": "info", "msg": "busy"})
                time.sleep(0.1 * TIMEOUT_S)

    def _message(self, connection):
        size = self._bytes(connection, 2)[1] & 0x7F
        if size == 126:
            size, = struct.unpack(">H", self._bytes(connection, 2))
        mask = self._bytes(connection, 4)
        text = bytes(byte ^ mask[i % 4] for i, byte in enumerate(self._bytes(connection, size)))
        return json.loads(text) if text.startswith(b"{") else {}

    @staticmethod
    def _bytes(connection, count):
        data = b""
        while len(data) < count:
            more = connection.recv(count - len(data))
            if not more:
                raise EOFError
            data += more
        return data

    @staticmethod
    def _send(connection, message):
        text = json.dumps(message).encode()
        connection.sendall(b"\x81" + (bytes([len(text)]) if len(text) < 126 else b"\x7e" + struct.pack(">H", len(text))) + text)


class SilentServer(unittest.TestCase):
    def ctl(self, server, *arguments, scheme="ws"):
        return subprocess.run([COMMAND, "ctl", "--url", f"{scheme}://127.0.0.1:{server.port}", "--timeout", str(TIMEOUT_S),
                               *arguments], capture_output=True, text=True, timeout=LATEST_S)

    def assert_no_answer(self, result):
        self.assertEqual(result.returncode, NO_ANSWER, result.stdout + result.stderr)
        self.assertRegex(result.stderr, f"no (answer|message) within {TIMEOUT_S} s")

    def test_one_that_is_silent_from_the_start(self):
        for scheme in ("ws", "wss"):
            with self.subTest(scheme), Server(shakes_hands=False) as server:
                self.assert_no_answer(self.ctl(server, "stop", scheme=scheme))

    def test_one_that_shakes_hands_and_falls_silent(self):
        for order in (["stop"], ["plugin", "list"], ["topics"], ["echo", "/odom"], ["walk", "0.1"]):
            with self.subTest(order), Server() as server:
                self.assert_no_answer(self.ctl(server, *order))

    def test_one_that_tells_of_all_but_the_answer(self):
        with Server(chatters=True) as server:
            self.assert_no_answer(self.ctl(server, "stop"))

    def test_one_that_answers_but_does_not_close(self):
        with Server(answers=["/stop"]) as server:
            result = self.ctl(server, "stop")
            self.assertEqual((result.returncode, result.stdout), (0, "/stop: done\n"), result.stderr)

    def walk(self, server, timeout_s):
        return subprocess.Popen([COMMAND, "ctl", "--port", str(server.port), "--timeout", str(timeout_s), "walk", "0.1", "--seconds",
                                 "3600"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def test_a_signal_ends_a_walk_with_a_stand(self):
        lease = "/command/acquire"
        renewal = "/command/keep_alive"
        for stop in (signal.SIGINT, signal.SIGTERM):
            for answers, code in (([lease, renewal, "/stand"], 0), ([lease, "/stand"], 0), ([lease], NO_ANSWER)):
                with self.subTest(stop=stop, answers=answers), Server(answers=answers) as server:
                    with self.walk(server, 3600.0 if "/stand" in answers else 2.0) as walk:
                        try:
                            until(lambda: renewal in server.called, "the walk")
                            walk.send_signal(stop)
                            self.assertEqual(walk.wait(LATEST_S), code)
                        finally:
                            walk.kill()
                    self.assertEqual(server.called[-1], "/stand")

    def test_a_second_signal_ends_a_walk_at_once(self):
        with Server(answers=["/command/acquire"]) as server, self.walk(server, 3600.0) as walk:
            try:
                until(lambda: "/command/keep_alive" in server.called, "the walk")
                walk.send_signal(signal.SIGINT)
                until(lambda: "/stand" in server.called, "the stand")
                walk.send_signal(signal.SIGINT)
                self.assertEqual(walk.wait(LATEST_S), -signal.SIGINT)
            finally:
                walk.kill()


if __name__ == "__main__":
    unittest.main(verbosity=2)
