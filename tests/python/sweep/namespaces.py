"""A network that can be cut and a disk that is small, each of its own for one part of a cluster: Linux namespaces, also without root."""

from __future__ import annotations

import contextlib
import pathlib
import subprocess

NEAR, FAR = "10.91.0.1", "10.91.0.2"
UNSHARE = ["unshare", "--user", "--map-root-user"]


def missing() -> str:
    """Why this computer has none; empty: it has."""
    line = [*UNSHARE, "--net", "--mount", "sh", "-c", "mount -t tmpfs tmpfs /mnt && ip link add near type veth peer name far"]
    try:
        tried = subprocess.run(line, capture_output=True, text=True, check=False)
    except OSError as error:
        return str(error)
    return "" if tried.returncode == 0 else f"no namespaces: {tried.stderr.strip()}"


def with_small_disk(folder: pathlib.Path, kibibytes: int) -> list[str]:
    """Before a command, which then has its own disk of that size in the place of the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    mount = f"mount -t tmpfs -o size={kibibytes}k tmpfs '{folder}' && exec \"$@\""
    return [*UNSHARE, "--mount", "sh", "-c", mount, "sh"]


class Cable:
    """Between two networks that have nothing else: `near`, `far`: before a command that shall be in one of them."""

    def __init__(self) -> None:
        self._holders: list[subprocess.Popen[str]] = []
        self.near = self._network([*UNSHARE, "--net"])
        self.far = self._network([*self.near, "unshare", "--net"])
        far_pid = self._holders[-1].pid
        self._ip(self.near, f"link add near type veth peer name far netns {far_pid}")
        for where, device, address in ((self.near, "near", NEAR), (self.far, "far", FAR)):
            for words in ("link set lo up", f"address add {address}/24 dev {device}", f"link set {device} up"):
                self._ip(where, words)

    def cut(self) -> None:
        """What is sent from now on is lost. Nobody is told."""
        self._ip(self.far, "link set far down")
        assert "NO-CARRIER" in self._ip(self.near, "link show near")

    def mend(self) -> None:
        self._ip(self.far, "link set far up")

    def __enter__(self) -> Cable:
        return self

    def __exit__(self, *_: object) -> None:
        for holder in reversed(self._holders):
            with contextlib.suppress(ProcessLookupError):
                holder.kill()
            holder.wait()
            if holder.stdout:
                holder.stdout.close()

    def _network(self, new: list[str]) -> list[str]:
        """A process keeps it."""
        holder = subprocess.Popen([*new, "sh", "-c", "echo ready; exec sleep infinity"], stdout=subprocess.PIPE, text=True)
        self._holders.append(holder)
        assert holder.stdout and holder.stdout.readline() == "ready\n"
        return ["nsenter", f"--target={holder.pid}", "--user", "--net", "--preserve-credentials"]

    @staticmethod
    def _ip(where: list[str], words: str) -> str:
        return subprocess.run([*where, "ip", *words.split()], check=True, capture_output=True, text=True).stdout
