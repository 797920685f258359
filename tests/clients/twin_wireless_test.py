"""The twin of a robot on another computer: both sides are processes with a network of their own, with a bad wireless link in between (TLS and
token, 5 Mbit/s, 10 ms, 3 % lost in fades). What is sent goes through the pre-flight gate; a link that is lost in the middle of a way leaves
the robot standing, and once it is back, the rest is walked. Without the rights for that (exit code 77) it is skipped."""
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from served_robot import COMMAND, until

ADDRESS, TOKEN = "10.77.0.1", "of-the-robot-there"
NO_ISOLATION = 77
GOAL = [1.2, 0.2, 0.0]


def main():
    with tempfile.TemporaryDirectory(prefix="gaitway_twin_") as folder:
        files = {name: str(Path(folder) / name) for name in ("token", "certificate.pem", "key.pem", "control", "out")}
        os.umask(0o077)  # nobody else may read the token
        Path(files["token"]).write_text(TOKEN + "\n")
        subprocess.run(["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "30", "-keyout", files["key.pem"], "-out", files["certificate.pem"],
                        "-subj", f"/CN={ADDRESS}", "-addext", f"subjectAltName=IP:{ADDRESS}"], check=True, capture_output=True)
        robot = [COMMAND, "serve", "--world", "empty", "--address", ADDRESS, "--token-file", files["token"], "--certificate-file", files["certificate.pem"],
                 "--key-file", files["key.pem"], "--out", files["out"]]
        link = [COMMAND, "wireless", "--quiet", "--rate", "5Mbit", "--delay", "10ms", "--loss", "3%", "--fade", "40ms", "--seed", "1", "--control", files["control"],
                "--robot", " ".join(robot), "--robot-ready", "serves wss", "--", sys.executable, __file__, files["token"], files["certificate.pem"]]
        done = subprocess.run(link, timeout=280)
        if done.returncode == NO_ISOLATION:
            print("skipped: this machine has no TUN or no network namespaces for this user", flush=True)
        sys.exit(done.returncode)


def client(token_file, certificate):
    """Runs where the link's client is."""
    from simulator import Simulator
    from twin_client import SEND, Client

    with Simulator("--robot", f"wss://{ADDRESS}:9090", "--robot-token-file", token_file, "--robot-ca", certificate, "--preflight-robots", "4") as simulator:
        here = Client(simulator.port, {"/simulation/twin": "gaitway_msgs/msg/TwinState"})

        def twin():
            return here.newest.get("/simulation/twin", {"state": "none", "sending": "none", "activity": "none"})

        def place_x():
            return dict(zip(twin()["channels"], twin()["measured"]))["place x"]

        def send(**task):
            answer = here.call("/simulation/twin/send", SEND, **task)
            assert answer["success"], answer
            until(lambda: twin()["sending"] == "sending", lambda: f"its way there: {twin()}", 60)

        until(lambda: twin()["state"] == "connected" and twin()["activity"] == "stands", lambda: f"the robot there: {twin()}", 30)
        send(goal=GOAL)
        until(lambda: twin()["activity"] == "walks", lambda: f"the walk: {twin()}", 20)
        time.sleep(2.0)  # some steps
        with open(os.environ["GAITWAY_WIRELESS_CONTROL"], "w") as control:
            control.write("outage 8s\n")
        until(lambda: twin()["state"] == "lost", lambda: f"that the link is lost: {twin()}", 15)
        until(lambda: twin()["sending"] == "failed", lambda: f"the mission's end: {twin()}", 20)
        until(lambda: twin()["state"] == "connected", lambda: f"the link: {twin()}", 30)
        until(lambda: twin()["activity"] == "stands" and place_x() is not None, lambda: f"the stand: {twin()}", 5)
        assert place_x() < GOAL[0] - 0.1, f"it went on without us: {twin()}"
        send(goal=GOAL)
        until(lambda: twin()["sending"] != "sending", lambda: f"the end: {twin()}", 60)
        assert twin()["sending"] == "done", twin()
        until(lambda: abs((place_x() or 0.0) - GOAL[0]) < 0.03, lambda: f"the goal: {twin()}", 10)
        here.close()
    print("walked there, in two parts", flush=True)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        client(*sys.argv[1:])
    else:
        main()
