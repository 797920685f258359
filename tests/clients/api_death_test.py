"""The user interface module is killed while it drives the robot, or the plug-in at the other end of its link: the robot stands, nothing else is
disturbed, the API is back within a second, and clients go on.

GAITWAY_DEATHS, of the module, at seeded instants of the walk and of what clients do: each once in every run, a hundred with `./dev test --long`.
"""
import json
import os
import random
import re
import select
import socket
import ssl
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from mcap.exceptions import EndOfFile
from mcap.records import Message
from mcap.stream_reader import StreamReader

from plain_websocket import PlainWebSocket, secret_options, upgrade_request
from served_robot import COMMAND, ServedRobot, until

DEATHS = int(os.environ.get("GAITWAY_DEATHS", "5"))
SEED = int(os.environ.get("GAITWAY_SEED", "1"))
TOKEN = "a-token-of-some-length-4711"
CYCLE_S = 0.08  # of batches
VELOCITY_S = 0.5  # that a velocity holds
STOP_S = 1.5  # from the order to stand to the stand: the step under way, and one that closes the feet
BACK_S = 1.0
LIFE_S = 2.1  # one that dies sooner is started again later each time (tools/serve/module_keeper.cpp)
WALK = {"op": "publish", "topic": "/cmd_vel", "msg": {"linear": {"x": 0.12}}}
TOPICS = ["/clock", "/odom", "/robot_state", "/commander"]


class Client:
    """One that keeps the newest of what it is told, and by when it knew it."""

    def __init__(self, port, token=None):
        self.websocket = PlainWebSocket("127.0.0.1", port, token=token, timeout_s=1.0)
        self.newest, self.answers = {}, {}
        self.clock_s, self.clock_at = 0.0, 0.0
        for topic in TOPICS:
            self.websocket.send({"op": "subscribe", "topic": topic, "queue_length": 1})

    def listen(self, seconds=0.01):
        select.select([self.websocket.socket], [], [], seconds)
        for message in self.websocket.messages():
            if message["op"] == "publish":
                self.newest[message["topic"]] = message["msg"]
                if message["topic"] == "/clock":
                    self.clock_s, self.clock_at = stamp_s(message["msg"]["clock"]), time.monotonic()
            elif message["op"] == "service_response":
                self.answers[message["service"]] = message["values"]

    def until(self, condition, what, timeout_s=20.0):
        end = time.monotonic() + timeout_s
        while not condition():
            assert time.monotonic() < end, f"not within {timeout_s} s: {what}; {self.newest} {self.answers}"
            self.listen()

    def answer_of(self, service, **arguments):
        self.answers.pop(service, None)
        self.websocket.call(service, **arguments)
        self.until(lambda: service in self.answers, service)
        return self.answers[service]

    def state(self):
        return self.newest.get("/robot_state", {}).get("state")

    def x(self):
        return self.newest["/odom"]["pose"]["pose"]["position"]["x"]

    def speed(self):
        return abs(self.newest["/odom"]["twist"]["twist"]["linear"]["x"])


def stamp_s(stamp):
    return stamp["sec"] + 1e-9 * stamp["nanosec"]


class Deaths:
    """Of one robot's module, one after the other; what was measured of each."""

    def __init__(self, test, robot, seed, token=None):
        self.test, self.robot, self.token = test, robot, token
        self.random = random.Random(seed)
        self.client = self.connect()
        self.served_at = time.monotonic()
        self.serves_s, self.links_s, self.stands_s, self.instants_s, self.recordings = [], [], [], [], []

    def connect(self):
        return Client(self.robot.port, self.token)

    def take_command(self):
        taken = self.client.answer_of("/command/acquire", name="driver")
        self.test.assertTrue(taken["success"], taken)

    def walk(self, seconds):
        """Until it has walked for so long, of the robot's time, at least."""
        client = self.client
        client.until(lambda: "/odom" in client.newest and client.clock_at, "the state")
        start, said, walks_since = client.x(), 0.0, None
        end = time.monotonic() + 30.0
        while walks_since is None or client.clock_s < walks_since + seconds:
            assert time.monotonic() < end, f"it does not walk: {client.newest} {client.answers}"
            if time.monotonic() - said > 0.02:
                said = time.monotonic()
                client.websocket.send(WALK)
            client.listen(0.002)
            if walks_since is None and client.state() == "walks" and client.x() > start + 0.05:
                walks_since = client.clock_s
        self.test.assertEqual(client.newest["/commander"]["data"], "driver")

    def one(self, meanwhile):
        """`meanwhile(self)` says what clients are at while the module dies, and gives what is looked at afterwards, or nothing."""
        self.take_command()
        self.walk(max(0.0, self.served_at + LIFE_S - time.monotonic()) * self.robot.speed + self.random.uniform(0.0, 2.0))
        afterwards = meanwhile(self)
        pause_until = time.monotonic() + self.random.uniform(0.0, 0.004)
        while time.monotonic() < pause_until:
            pass
        killed_clock_s, killed_at = self.client.clock_s, time.monotonic()
        os.kill(self.robot.api_process(), 9)
        dead, self.client = self.client, self.back(killed_at)
        self.test.assertTrue(has_ended(dead.websocket), "its connections are cut")
        dead.websocket.close()
        client = self.client
        client.until(lambda: client.state() and "/commander" in client.newest, "the state")
        self.links_s.append(time.monotonic() - killed_at)
        self.test.assertEqual(client.newest["/commander"]["data"], "", "who commanded has the command no more")
        client.until(lambda: client.state() == "stands", "the stand")
        self.instants_s.append(killed_clock_s)
        self.stands_s.append(stamp_s(client.newest["/robot_state"]["header"]["stamp"]) - killed_clock_s)
        client.until(lambda: client.speed() < 0.01, "the stand")
        if afterwards:
            afterwards()

    def back(self, killed_at):
        """A client that has come in again."""
        while True:
            try:
                client = self.connect()
                self.served_at = time.monotonic()
                self.serves_s.append(self.served_at - killed_at)
                return client
            except (ConnectionError, TimeoutError, ssl.SSLError) as error:
                self.test.assertLess(time.monotonic() - killed_at, 10.0, f"it does not come back: {error}")
                time.sleep(0.002)

    def tell(self):
        def figures(values):
            values = sorted(values)
            return ", ".join(f"{name} {1e3 * values[min(len(values) - 1, int(part * len(values)))]:.0f} ms"
                             for name, part in (("p50", 0.5), ("p99", 0.99), ("worst", 1.0)))
        slots = [int(instant % CYCLE_S * 100.0) for instant in self.instants_s]
        print(f"{len(self.stands_s)} deaths of the module; robot's time from the kill to the stand: {figures(self.stands_s)}; "
              f"until it serves: {figures(self.serves_s)}, and the robot's state with it: {figures(self.links_s)}; "
              f"kills in the slots of the batches' cycle: {[slots.count(slot) for slot in range(8)]}")

    def check(self):
        for stands_s, links_s in zip(self.stands_s, self.links_s):
            self.test.assertLessEqual(stands_s, VELOCITY_S + STOP_S)
            self.test.assertLessEqual(links_s, BACK_S)


def has_ended(websocket, timeout_s=5.0):
    """Whether the other end is gone."""
    try:
        end = time.monotonic() + timeout_s
        while not websocket.ended and time.monotonic() < end:
            select.select([websocket.socket], [], [], 0.1)
            for _ in websocket.payloads():
                pass
        return websocket.ended
    except OSError:
        return True


# --- What clients are at while the module dies ------------------------------------------------------------------------------------------

def nothing_else(_):
    return None


def an_order(deaths):
    """Some of them are under way on the link."""
    for value in ("0.05 rad", "0.06 rad"):
        deaths.client.websocket.call("/plugins/set_parameter", plugin="stability", parameter="trim_limit", value=value)
    deaths.client.websocket.call("/play_motion", motion="wave")
    deaths.client.websocket.send(WALK)

    def afterwards():
        deaths.test.assertEqual(deaths.client.state(), "stands", "no motion begins by itself")
        values = deaths.client.answer_of("/plugins/get_parameters", plugin="stability")
        deaths.test.assertTrue(values["success"], values)
    return afterwards


def a_take_of_the_command(deaths):
    """From one to another, who drives on."""
    other = deaths.connect()
    lease = deaths.client.answer_of("/command/acquire", name="driver")["lease"]
    deaths.client.websocket.call("/command/release", lease=lease)
    other.websocket.call("/command/acquire", name="other")
    other.websocket.send(WALK)
    deaths.client.websocket.send(WALK)

    def afterwards():
        deaths.test.assertTrue(has_ended(other.websocket))
        other.websocket.close()
    return afterwards


def a_handshake(deaths):
    """Some have said half of what they must, one all of it."""
    def begun(whole):
        request = upgrade_request("127.0.0.1")
        came = socket.create_connection(("127.0.0.1", deaths.robot.port))
        came.sendall(request if whole else request[:len(request) // 2])
        return came

    def tls_begun(whole):
        came = socket.create_connection(("127.0.0.1", deaths.robot.port))
        sent = ssl.MemoryBIO()
        tls = ssl._create_unverified_context().wrap_bio(ssl.MemoryBIO(), sent)
        try:
            tls.do_handshake()
        except ssl.SSLWantReadError:
            pass
        hello = sent.read()
        came.sendall(hello if whole else hello[:len(hello) // 2])
        return came
    come = [(tls_begun if deaths.token else begun)(whole) for whole in (False, False, True)]

    def afterwards():
        for socket_ in come:
            socket_.settimeout(5.0)
            try:
                while socket_.recv(4096):
                    pass
            except ConnectionError:
                pass  # cut, too
            socket_.close()
    return afterwards


def a_recording(deaths):
    """It can be read afterwards, up to some time before the end, and another one can be made."""
    name = f"death_{len(deaths.recordings)}"
    started = deaths.client.answer_of("/recording/start", name=name)
    deaths.test.assertTrue(started["success"], started)
    began_s = deaths.client.clock_s
    deaths.walk(2.5 * deaths.robot.speed)

    def afterwards():
        recorded = read_recording(Path(started["file"]))
        deaths.recordings.append(deaths.instants_s[-1] - max(recorded))
        deaths.test.assertLessEqual(min(recorded), began_s + 1.0)
        again = deaths.client.answer_of("/recording/start", name=name)
        deaths.test.assertFalse(again["success"], "nothing is written over what there is")
        another = deaths.client.answer_of("/recording/start", name=f"{name}_another")
        deaths.test.assertTrue(another["success"], another)
        deaths.test.assertTrue(deaths.client.answer_of("/recording/stop")["success"])
    return afterwards


def read_recording(file):
    """Robot's time of each message that can be read."""
    times_s = []
    with open(file, "rb") as stream:
        try:
            times_s.extend(1e-9 * record.log_time for record in StreamReader(stream, validate_crcs=True).records if isinstance(record, Message))
        except EndOfFile:
            pass  # it was killed
    return times_s


SCENES = [nothing_else, an_order, a_take_of_the_command, a_handshake, a_recording]


class ApiDeath(unittest.TestCase):
    def ctl(self, *arguments):
        return subprocess.run([COMMAND, "ctl", "--url", f"ws://127.0.0.1:{self.robot.port}", *arguments], capture_output=True,
                              text=True, timeout=60)

    def odometry(self):
        return json.loads(self.ctl("echo", "/odom").stdout)

    def position(self):
        return self.odometry()["pose"]["pose"]["position"]["x"]

    def speed(self):
        return abs(self.odometry()["twist"]["twist"]["linear"]["x"])

    def assert_undisturbed(self, robot, deaths):
        summary, commands = robot.summary, (robot.out / "commands.yaml").read_text()
        self.assertFalse(summary["fell"])
        self.assertEqual(summary["batches"]["late"], 0)
        self.assertEqual(summary["batches"]["refused"], 0)
        # Each walk was ended by a stand, or by the word that its commander is lost, half a second after its last renewal at the latest; a
        # motion that was asked for before a death has come before that, or not at all.
        entries = [(float(at), "stand" if kind == "command: is_lost" else kind) for at, kind in
                   re.findall(r"at_s: ([\d.]+), (?:asked: true, )?(walk|stand|motion|command: is_lost)", commands)]
        ends = [(stood_at, stood_at - walked_at) for (walked_at, before), (stood_at, after) in zip(entries, entries[1:])
                if before != "stand" and after == "stand"]
        self.assertGreaterEqual(len(ends), deaths)
        self.assertEqual([end for end in ends if end[1] > VELOCITY_S + 0.002], [])
        self.assertEqual([(before, after) for before, after in zip(entries, entries[1:])
                          if before[1] == "stand" and after[1] == "motion"], [], "an order of before the death")

    def test_the_robot_stands_and_the_api_comes_back(self):
        with ServedRobot(speed=2.0) as robot:
            deaths = Deaths(self, robot, SEED)
            for death in range(DEATHS):
                deaths.one(SCENES[death % len(SCENES)])
            deaths.take_command()
            deaths.walk(0.5)  # who has come in again walks it
            robot.stop()
            deaths.tell()
            print(f"recordings end at most {max(deaths.recordings, default=0.0):.1f} s before the kill")
            deaths.check()
            self.assert_undisturbed(robot, DEATHS)
            print(f"batches: {robot.summary['batches']}")

    def test_the_same_over_tls(self):
        with tempfile.TemporaryDirectory(prefix="gaitway_secrets_") as folder, \
                ServedRobot(*map(str, secret_options(Path(folder), TOKEN)), speed=2.0) as robot:
            deaths = Deaths(self, robot, SEED + 1, TOKEN)
            for _ in range(max(1, DEATHS // 10)):
                deaths.one(a_handshake)
            robot.stop()
            deaths.tell()
            deaths.check()
            self.assert_undisturbed(robot, len(deaths.stands_s))

    def test_the_plugins_end_is_a_link_that_comes_back(self):
        with ServedRobot() as self.robot:
            start = self.position()
            driver = subprocess.Popen([COMMAND, "ctl", "--url", f"ws://127.0.0.1:{self.robot.port}", "walk", "0.12", "--seconds", "60"],
                                      stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            until(lambda: self.position() > start + 0.1, "10 cm of walk", 30.0)
            os.kill(self.robot.plugin_process(), 9)
            self.robot.wait_for_line("the link to the main controller is lost")
            self.assertEqual(driver.wait(30), 1, "who commanded has the command no more")
            self.assertRegex(driver.stderr.read(), "is not there|let go")
            driver.stderr.close()
            until(lambda: self.ctl("stand").returncode == 0, "a client that goes on")
            until(lambda: self.speed() < 0.01, "the stand")
            self.robot.stop()
        self.assertFalse(self.robot.summary["fell"])
        self.assertEqual(self.robot.summary["batches"]["late"], 0)
        self.assertEqual(len(self.robot.ports), 1, "the module goes on")


if __name__ == "__main__":
    unittest.main(verbosity=2)
