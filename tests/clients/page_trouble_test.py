"""Runs page_trouble_test.mjs in a browser: what the page says when it is not the robot's page any more, when its module is refused by the
robot, when nobody is at the other end of the link, and when the certificate has expired."""
import contextlib
import datetime
import os
import re
import shutil
import signal
import subprocess
import tempfile
import threading
from pathlib import Path

from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec

from served_robot import ServedRobot, free_port

TOKEN = "a-token-for-the-page-4711"
CALIBRATION = """robot: humanoid22
made: 2026-11-25T03:21:29Z
joint_zeros_deg:
  left_knee: {value: -0.5, deviation: 0.03}
trunk_com_offset_m: {value: [0.004, -0.002, 0.01], deviation: [0.001, 0.001, 0.003]}
force_cell_gains:
  left: {value: [1.01, 0.99, 1.02, 0.98]}
  right: {value: [1.03, 1.0, 1.0, 0.97], deviation: [0.01, 0.01, 0.01, 0.01]}
"""


class Module:
    """A user interface module of its own, with what it says."""

    def __init__(self, robot, link, *arguments):
        self.port = str(free_port())
        self.lines = []
        self._news = threading.Condition()
        self.process = subprocess.Popen([os.environ["GAITWAY_USER_INTERFACE"], "--robot", str(robot), "--link", link, "--port", self.port,
                                         "--stop-port", "0", *arguments], stderr=subprocess.PIPE, text=True)
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        self.wait_for("serves wss?://")

    def _read(self):
        for line in self.process.stderr:
            with self._news:
                self.lines.append(line.rstrip())
                self._news.notify_all()

    def wait_for(self, pattern):
        with self._news:
            found = self._news.wait_for(lambda: any(re.search(pattern, line) for line in self.lines), 30)
        assert found, f"no line like '{pattern}':\n" + "\n".join(self.lines)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(20)
        self._reader.join(10)
        self.process.stderr.close()


def write_expired_certificate(folder):
    key = ec.generate_private_key(ec.SECP256R1())
    name = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, "localhost")])
    now = datetime.datetime.now(datetime.timezone.utc)
    certificate = (x509.CertificateBuilder().subject_name(name).issuer_name(name).public_key(key.public_key())
                   .serial_number(x509.random_serial_number()).not_valid_before(now - datetime.timedelta(days=10))
                   .not_valid_after(now - datetime.timedelta(days=1, hours=1)).sign(key, hashes.SHA256()))
    (folder / "cert.pem").write_bytes(certificate.public_bytes(serialization.Encoding.PEM))
    (folder / "key.pem").touch(mode=0o600)
    (folder / "key.pem").write_bytes(key.private_bytes(serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8,
                                                       serialization.NoEncryption()))
    (folder / "token").touch(mode=0o600)
    (folder / "token").write_text(TOKEN)
    return ["--token-file", str(folder / "token"), "--certificate-file", str(folder / "cert.pem"), "--key-file", str(folder / "key.pem")]


def link_of(robot):
    """Where the main controller of a served robot waits for its module."""
    command = Path(f"/proc/{robot.api_process()}/cmdline").read_text().split("\0")
    return command[command.index("--link") + 1]


def robot_folder(path, changes):
    """humanoid22's folder with further text at the end of some files."""
    shutil.copytree(os.environ["GAITWAY_ROBOT"], path)
    for name, text in changes.items():
        with open(path / name, "a", encoding="utf-8") as file:
            file.write(text)
    return path


with tempfile.TemporaryDirectory(prefix="gaitway_page_") as name, contextlib.ExitStack() as stack:
    folder = Path(name)
    served = stack.enter_context(ServedRobot())
    calibrated = robot_folder(folder / "calibrated", {"calibration.yaml": CALIBRATION})
    second = stack.enter_context(Module(calibrated, link_of(served)))
    # Of another robot, whose own module sleeps: a robot has one.
    strange = stack.enter_context(ServedRobot())
    os.kill(strange.api_process(), signal.SIGSTOP)
    stack.callback(os.kill, strange.api_process(), signal.SIGCONT)
    other = stack.enter_context(Module(robot_folder(folder / "other", {"robot.yaml": "\n# another description\n"}), link_of(strange)))
    alone = stack.enter_context(Module(calibrated, f"unix:{folder}/link.sock", *write_expired_certificate(folder)))
    second.wait_for(r"no link to the main controller: refused: .* linked to another module, 'user_interface \d+', and a robot has one")
    other.wait_for(r"no link to the main controller: refused: .* has the robot's description [0-9a-f]{8}, the other end, 'controller of humanoid22'")
    alone.wait_for(r"no link to the main controller: link '.*/link.sock': cannot connect")
    alone.wait_for(r"the certificate of 'localhost' in certificate_file '.*' expired on .*, 1 day ago")
    script = Path(__file__).with_name("page_trouble_test.mjs")
    subprocess.run([os.environ["GAITWAY_NODE"], "--test-reporter=spec", str(script), str(served.port), second.port, other.port, alone.port,
                    TOKEN, str(folder)], check=True, timeout=200)
    served.wait_for_line("a page of another version, which its browser must load again: 127.0.0.1, page 'feedfeedfeedfeed'")
    strange.wait_for_line("no link to the user interface module: refused: 'controller of humanoid22' has the robot's description")
    assert any("another user interface module (process " in line for line in served.lines), served.lines
