"""A WebSocket to the robot API, in the thread of whoever has it, for tests and measurements that want to know when what was said. And what a robot
wants that is reached over TLS."""
import base64
import json
import os
import select
import socket
import ssl
import struct
import subprocess
import time


class PlainWebSocket:
    """As much of one as is needed: messages both ways, and a sign of life. With `token` over TLS, whoever's the certificate is."""

    def __init__(self, host, port, target="/", token=None, timeout_s=None):
        self.socket = socket.create_connection((host, port), timeout_s)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.ended = False
        self.unread = b""
        try:
            self._shake_hands(host, target, token)
        except BaseException:
            self.socket.close()
            raise
        self.socket.setblocking(False)

    def _shake_hands(self, host, target, token):
        if token:
            self.socket = ssl._create_unverified_context().wrap_socket(self.socket)
        self.socket.sendall(upgrade_request(host, target))
        while b"\r\n\r\n" not in self.unread:
            come = self.socket.recv(4096)
            if not come:
                raise ConnectionError("the robot has ended the connection")
            self.unread += come
        head, self.unread = self.unread.split(b"\r\n\r\n", 1)
        if b" 101 " not in head:
            raise ConnectionError(head.decode(errors="replace"))
        if token:
            self.frame(1, (token if target == "/view" else json.dumps({"op": "auth", "token": token})).encode())

    def close(self):
        self.ended = True
        self.socket.close()

    def frame(self, opcode, payload):
        mask = os.urandom(4)
        size = struct.pack("!B", 0x80 | len(payload)) if len(payload) < 126 else struct.pack("!BH", 0xFE, len(payload))
        data = bytes([0x80 | opcode]) + size + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(payload))
        while data:
            try:
                data = data[self.socket.send(data):]
            except (BlockingIOError, ssl.SSLWantWriteError):
                select.select([], [self.socket], [], 1.0)

    def send(self, message):
        self.frame(1, json.dumps(message).encode())

    def call(self, service, **arguments):
        """Without waiting for the answer."""
        self.send({"op": "call_service", "service": service, "args": arguments})

    def payloads(self):
        """(opcode, payload) of what has come. Pings are answered: by that the robot knows how old what comes after may be."""
        try:
            while data := self.socket.recv(65536):
                self.unread += data
            self.ended = True
        except (BlockingIOError, ssl.SSLWantReadError):
            pass
        while len(self.unread) >= 2:
            short = self.unread[1] & 127
            header, form = {126: (4, "!H"), 127: (10, "!Q")}.get(short, (2, None))
            if len(self.unread) < header:
                return
            size = struct.unpack(form, self.unread[2:header])[0] if form else short
            if len(self.unread) < header + size:
                return
            opcode, payload = self.unread[0] & 15, self.unread[header:header + size]
            self.unread = self.unread[header + size:]
            if opcode == 9:
                self.frame(10, payload)
            elif opcode in (1, 2):
                yield opcode, payload
            elif opcode == 8:
                raise ConnectionError(f"the robot has ended the connection: {payload[2:].decode()}")

    def messages(self):
        return [json.loads(payload) for opcode, payload in self.payloads() if opcode == 1]

    def answer_of(self, service, arguments):
        self.call(service, **arguments)
        end = time.monotonic() + 5.0
        while time.monotonic() < end:
            for message in self.messages():
                if message["op"] == "service_response" and message["service"] == service:
                    return message["values"]
            select.select([self.socket], [], [], 0.005)
        raise TimeoutError(f"no answer to {service}")


def upgrade_request(host, target="/"):
    key = base64.b64encode(os.urandom(16)).decode()
    return (f"GET {target} HTTP/1.1\r\nHost: {host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n").encode()


def secret_options(folder, token):
    """Options of the module: a token, and a certificate that nobody knows."""
    (folder / "token").touch(0o600)
    (folder / "token").write_text(token + "\n")
    subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days", "1", "-subj",
                    "/CN=robot", "-keyout", folder / "key.pem", "-out", folder / "certificate.pem"], check=True, capture_output=True)
    return ["--token-file", folder / "token", "--certificate-file", folder / "certificate.pem", "--key-file", folder / "key.pem"]
