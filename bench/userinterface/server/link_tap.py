"""Between the user interface module and the plug-in api, on their Unix socket: passes on what they say, and notes when orders and stops come from the module."""
import multiprocessing
import os
import select
import socket
import time

KINDS = {3: "stop", 5: "order"}  # of frames (userinterface/link/README.md), as the link says them


def kinds_in(unread):
    """The kinds of the whole frames, and what is left: frames are between zeros, and the first byte of their content stands as it is."""
    *frames, rest = unread.split(b"\0")
    return [frame[1] for frame in frames if len(frame) > 2], rest


def relay(tapped, link, notes):
    listener = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    listener.bind(tapped)
    listener.listen()
    while True:
        near, _ = listener.accept()
        far = socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        try:
            far.connect(link)
            pass_on(near, far, notes)
        except OSError:
            pass  # the module comes again
        near.close()
        far.close()


def pass_on(module, plugin, notes):
    unread = b""
    while True:
        for ready in select.select([module, plugin], [], [])[0]:
            data = ready.recv(65536)
            come_s = time.monotonic()
            if not data:
                return
            (plugin if ready is module else module).sendall(data)
            if ready is module:
                kinds, unread = kinds_in(unread + data)
                for kind in kinds:
                    if kind in KINDS:
                        os.write(notes, f"{come_s!r} {KINDS[kind]}\n".encode())


class LinkTap:
    """Listens at `tapped` for the module; the plug-in does at `link`. A process of its own."""

    def __init__(self, tapped, link):
        self.notes, notes = os.pipe()
        os.set_blocking(self.notes, False)
        self.process = multiprocessing.Process(target=relay, args=(str(tapped), str(link), notes), daemon=True)
        self.process.start()
        os.close(notes)
        self.unread = b""

    def said(self):
        """(time, "stop" or "order") of what has come since the last time."""
        try:
            while data := os.read(self.notes, 65536):
                self.unread += data
        except BlockingIOError:
            pass
        *lines, self.unread = self.unread.split(b"\n")
        return [(float(line.split()[0]), line.split()[1].decode()) for line in lines]

    def end(self):
        self.process.kill()
        self.process.join()
        os.close(self.notes)
