#!/usr/bin/env python3
"""Stops a robot by datagram, with Python's standard library alone. What the datagrams say: userinterface/stopgram/README.md.

    python3 docs/examples/stop_client.py 127.0.0.1 9091
    python3 docs/examples/stop_client.py 192.168.1.7 9091 --kind soft --token-file token
"""
import argparse
import hmac
import pathlib
import secrets
import socket
import struct
import sys
import time

GREETING, WELCOME, STOP, ACK, STRANGER = 1, 2, 3, 4, 5
KINDS = {"stop": 0, "hold": 1, "soft": 2}  # end the walk; emergency stop: the joints hold, or let go
CODE_BYTES = 16
REPEAT_S = 0.01


class StopClient:
    def __init__(self, host, port, token=""):
        self._robot = (host, port)
        self._key = hmac.digest(token.encode(), b"gaitway stop datagrams 1", "sha256")
        self._client = secrets.randbits(64)
        self._greeting = 1
        self._stop = 0
        self._welcome = None  # epoch and stamp: the desk's time
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        self._socket = socket.socket(family, socket.SOCK_DGRAM)
        self._socket.settimeout(REPEAT_S)

    def stop(self, kind="stop", seconds=2.0):
        """Says the stop until the robot has obeyed it: "obeyed", "heard" (not obeyed in time) or "unanswered"."""
        self._stop += 1
        state = "unanswered"
        end = time.monotonic() + seconds
        while state != "obeyed" and time.monotonic() < end:
            said_at = time.monotonic()
            self._socket.sendto(self.next_datagram(kind), self._robot)
            for what, content in self._answers(said_at + REPEAT_S):
                if what == WELCOME and content[:12] == struct.pack("<QI", self._client, self._greeting):
                    self._welcome = struct.unpack("<Qq", content[12:])
                    self._greeting += 1
                    break  # and say the stop at once
                if what == ACK and content[:13] == struct.pack("<QIB", self._client, self._stop, KINDS[kind]):
                    state = "obeyed" if content[13] == 1 else "heard"
                if what == STRANGER and self._welcome and content == struct.pack("<QQq", self._client, *self._welcome):
                    self._welcome = None
        return state

    def next_datagram(self, kind):
        if self._welcome is None:
            return self._signed(GREETING, struct.pack("<QI16x", self._client, self._greeting))
        return self._signed(STOP, struct.pack("<QQqIB", self._client, *self._welcome, self._stop, KINDS[kind]))

    def _answers(self, until):
        while (left := until - time.monotonic()) > 0:
            self._socket.settimeout(left)
            try:
                datagram = self._socket.recv(2048)
            except TimeoutError:
                return
            content = datagram[:-CODE_BYTES]
            if content[:5] == b"GWTS\x01" and hmac.compare_digest(self._code(content), datagram[-CODE_BYTES:]):
                yield content[5], content[6:]

    def _signed(self, what, content):
        text = b"GWTS" + bytes([1, what]) + content
        return text + self._code(text)

    def _code(self, text):
        return hmac.digest(self._key, text, "sha256")[:CODE_BYTES]


def main():
    parser = argparse.ArgumentParser(description="Stops a robot by datagram.")
    parser.add_argument("host")
    parser.add_argument("port", type=int)
    parser.add_argument("--kind", choices=KINDS, default="stop")
    parser.add_argument("--token-file", type=pathlib.Path)
    parser.add_argument("--seconds", type=float, default=2.0)
    options = parser.parse_args()
    token = options.token_file.read_text().rstrip("\r\n") if options.token_file else ""
    state = StopClient(options.host, options.port, token).stop(options.kind, options.seconds)
    print(state)
    return {"obeyed": 0, "heard": 2, "unanswered": 3}[state]


if __name__ == "__main__":
    sys.exit(main())
