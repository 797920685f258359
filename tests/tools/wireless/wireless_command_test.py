"""`gaitway wireless` with real sockets: what programs measure through the link is what its options say."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

COMMAND = os.environ["GAITWAY_WIRELESS"]
NO_ISOLATION = 77

ECHO = """
import socket, sys
s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); s.bind(('10.77.0.1', 7000)); print('ready', flush=True)
while True:
    data, peer = s.recvfrom(2000); s.sendto(data, peer)
"""
# `count` datagrams, one every `period`; says for each that came back when it was sent and what it took.
PING = """
import json, os, socket, time
count, period = COUNT, PERIOD
s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); s.connect(('10.77.0.1', 7000)); s.settimeout(0)
came, sent = {}, {}
start = time.monotonic()
ORDER = ORDERS
for i in range(count + int(0.5 / period)):
    if i == ORDER: open(os.environ['GAITWAY_WIRELESS_CONTROL'], 'w').write('outage 0.4s\\n')
    if i < count:
        sent[i] = time.monotonic_ns(); s.send(str(i).encode())
    while True:
        wait = start + (i + 1) * period - time.monotonic()
        if wait <= 0: break
        s.settimeout(wait)
        try: number = int(s.recv(2000)); came[number] = time.monotonic_ns()
        except (TimeoutError, BlockingIOError): break
print(json.dumps([[sent[i], came.get(i)] for i in sent]))
"""
SINK = """
import socket
s = socket.create_server(('10.77.0.1', 7001)); print('ready', flush=True)
c, _ = s.accept(); total = 0
while data := c.recv(65536): total += len(data)
c.sendall(str(total).encode()); c.close()
"""
POUR = """
import socket, time
s = socket.create_connection(('10.77.0.1', 7001)); start = time.monotonic()
s.sendall(b'x' * BYTES); s.shutdown(socket.SHUT_WR)
assert int(s.recv(100)) == BYTES
print(time.monotonic() - start)
"""


class Wireless(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        tried = subprocess.run([COMMAND, "wireless", "--quiet", "--", "true"], capture_output=True, text=True)
        if tried.returncode == NO_ISOLATION:
            print("skipped:", tried.stderr.strip(), flush=True)
            sys.exit(NO_ISOLATION)

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="gaitway_wireless_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_link(self, options, robot, client, code=0):
        for name, text in {"robot.py": robot, "client.py": client}.items():
            (self.folder / name).write_text(text)
        run = subprocess.run(
            [COMMAND, "wireless", *options, "--json", self.folder / "json", "--robot-ready", "ready", "--robot",
             f"exec {sys.executable} {self.folder / 'robot.py'}", "--", sys.executable, self.folder / "client.py"],
            capture_output=True, text=True, timeout=120)
        self.assertEqual(run.returncode, code, run.stderr)
        self.result = json.loads((self.folder / "json").read_text())
        return run.stdout

    def ping(self, options, count, period, order=-1):
        client = PING.replace("COUNT", str(count)).replace("PERIOD", str(period)).replace("ORDERS", str(order))
        return json.loads(self.run_link(options, ECHO, client))

    def test_the_round_trip_is_twice_the_delay(self):
        trips = sorted((came - sent) * 1e-6 for sent, came in self.ping(["--delay", "10ms"], 200, 0.01) if came)
        self.assertEqual(len(trips), 200)
        self.assertGreaterEqual(trips[0], 20.0)
        self.assertLess(trips[100], 22.0)

    def test_loss_is_within_bounds(self):
        answers = self.ping(["--loss", "10%", "--burst", "2", "--seed", "3"], 2000, 0.001)
        share = sum(came is not None for _, came in answers) / len(answers)
        self.assertAlmostEqual(share, 0.81, delta=0.05)
        to_robot = self.result["to_robot"]
        self.assertEqual(to_robot["sent"], to_robot["delivered"] + to_robot["lost_on_air"])

    def test_tcp_gets_the_rate(self):
        size = 2_000_000
        took_s = float(self.run_link(["--rate", "5Mbit", "--delay", "10ms"], SINK, POUR.replace("BYTES", str(size))))
        self.assertGreater(size * 8 / took_s, 4.2e6)
        self.assertLess(size * 8 / took_s, 5.0e6)

    def test_tcp_gets_through_a_bad_link(self):
        self.run_link(["--rate", "5Mbit", "--delay", "5ms", "--loss", "3%", "--burst", "4", "--reorder", "1%",
                       "--duplicate", "1%"], SINK, POUR.replace("BYTES", "300000"))
        self.assertGreater(self.result["to_robot"]["lost_on_air"], 0)

    def test_a_planned_outage_cuts_and_heals(self):
        log = self.folder / "log"
        answers = self.ping(["--outage-at", "0.5s+0.3s", "--outage-log", log], 1500, 0.001)
        self.check_outage(answers, log, 0.3)
        began = self.result["outages"][0]["began_ns"]
        self.assertEqual(began - self.result["client_started_ns"], 500_000_000)

    def test_an_outage_on_command_cuts_and_heals(self):
        log = self.folder / "log"
        answers = self.ping(["--control", self.folder / "fifo", "--outage-log", log], 1500, 0.001, order=300)
        self.check_outage(answers, log, 0.4)
        self.assertFalse((self.folder / "fifo").exists())

    def check_outage(self, answers, log, length_s):
        began, ended = (json.loads(line) for line in log.read_text().splitlines())
        began, ended = began["began_ns"], ended["ended_ns"]
        self.assertAlmostEqual((ended - began) * 1e-9, length_s, delta=1e-6)
        for sent, came in answers:
            if began < sent < ended:
                self.assertIsNone(came)
            if came:
                self.assertFalse(began + 2_000_000 < came < ended)
        self.assertTrue(any(came and came > ended for _, came in answers))
        self.assertTrue(all(came for sent, came in answers if sent > ended + 5_000_000))
        self.assertGreater(self.result["to_robot"]["lost_in_outages"], 100 * length_s)

    def test_exit_codes(self):
        self.run_link([], "print('ready', flush=True)\nimport time; time.sleep(60)", "raise SystemExit(5)", code=5)
        self.run_link([], "print('ready', flush=True)", "import os; os.kill(os.getpid(), 9)", code=137)
        for options, code, words in ([["--robot", "true", "--robot-ready", "never"], 3, "before it was ready"],
                                     [["--robot", "sleep 60", "--robot-ready", "x", "--robot-ready-within", "0.1s"], 3, "in time"],
                                     [["--rate", "5"], 1, "--rate 5"], [["--loss", "3"], 1, "3%"],
                                     [["--delay", "1ms", "--jitter", "2ms"], 1, "jitter"]):
            run = subprocess.run([COMMAND, "wireless", *options, "--", "true"], capture_output=True, text=True, timeout=30)
            self.assertEqual(run.returncode, code, run.stderr)
            self.assertIn(words, run.stderr)

    def test_nobody_is_left_behind(self):
        self.run_link([], "import subprocess, time\nsubprocess.Popen(['sleep', '4242.4242'])\nprint('ready', flush=True)\n"
                          "time.sleep(60)", "pass")
        self.assertNotIn("4242.4242", subprocess.run(["ps", "ax"], capture_output=True, text=True).stdout)


if __name__ == "__main__":
    unittest.main(verbosity=2)
