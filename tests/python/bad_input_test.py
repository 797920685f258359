"""Whatever is wrong is told by an exception that names it, and the interpreter lives on."""

import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import gaitway

NAN, INFINITE = float("nan"), float("inf")


@pytest.fixture(scope="module")
def robot():
    with gaitway.Robot(seed=1) as made:
        made.run(0.3)
        yield made


@pytest.mark.parametrize(("call", "error", "tells"), [
    (lambda r: r.run(NAN), ValueError, "finite"),
    (lambda r: r.run(-1.0), ValueError, "negative"),
    (lambda r: r.run("1"), TypeError, "seconds = '1': must be a number"),
    (lambda r: r.walk(NAN), ValueError, None),
    (lambda r: r.walk(9.0), ValueError, "walk"),
    (lambda r: r.walk("fast"), TypeError, "vx = 'fast': must be a number"),
    (lambda r: r.run(np.complex64(1)), TypeError, "must be a number"),
    (lambda r: r.walk(10**400), TypeError, "must be a number"),
    (lambda r: r.push(r.links[0], 3), TypeError, "impulse = 3: must be a list"),
    (lambda r: r.walk(None), TypeError, "vx = None: must be a number"),
    (lambda r: r.push(r.links[0], (1j, 0, 0)), TypeError, "impulse = 1j: must be a number"),
    (lambda r: r.apply({"walk": [NAN, 0, 0]}), ValueError, r"action = {'walk': \[nan, 0, 0\]}: numbers must be finite"),
    (lambda r: r.apply({"walk": {1, 2}}), TypeError, "action = .*Take texts, numbers"),
    (lambda r: r.push("trunkk", (1, 0, 0)), ValueError, "Did you mean"),
    (lambda r: r.push(r.links[0], (1, 0)), ValueError, "three"),
    (lambda r: r.push(r.links[0], (NAN, 0, 0)), ValueError, "finite"),
    (lambda r: r.push(r.links[0], (0, 0, 0)), ValueError, "no direction"),
    (lambda r: r.push(r.links[0], (1e9, 0, 0)), ValueError, "impulse"),
    (lambda r: r.apply("wlak: [1, 0, 0]"), ValueError, "Did you mean 'walk'"),
    (lambda r: r.apply("{"), ValueError, None),
    (lambda r: r.apply({"fault": {"kind": "plugin_fails", "plugin": "zpm", "how": "throws"}}), ValueError, "zmp"),
    (lambda r: r.apply(3), TypeError, None),
    (lambda r: r.write("walk_request", {"velocity": [NAN, 0.0]}), ValueError, r"velocity\[0\] = nan"),
    (lambda r: r.write("walk_request", {"velocity": [INFINITE, 0.0]}), ValueError, "within"),
    (lambda r: r.write("walk_request", {"velocity": [99.0, 0.0]}), ValueError, "within"),
    (lambda r: r.write("walk_request", {"velocity": [1.0]}), ValueError, "shape"),
    (lambda r: r.write("walk_request", {"velocity": "ab"}), ValueError, "shape"),
    (lambda r: r.write("walk_request", {"walk": 0.5}), TypeError, "uint32"),
    (lambda r: r.write("walk_request", {"walk": -1}), (TypeError, ValueError), None),
    (lambda r: r.write("walk_request", {"walk": 2**40}), (TypeError, ValueError), None),
    (lambda r: r.write("walk_request", {1: 2}), TypeError, "'walk_request': a field goes by its name, a str; not by int"),
    (lambda r: r.write("walk_request", np.zeros(3)), TypeError, "mapping"),
    (lambda r: r.write("walk_request", r.topic("imu")), TypeError, "dtype"),
    (lambda r: r.write("imu", {}), gaitway.TopicError, "already written by 'message_controller'"),
    (lambda r: r.write("estimate", {}), gaitway.TopicError, r"already written by the plug-in zmp. Robot\(writes=\['estimate'\]\)"),
    (lambda r: r.write("motion_request", {"name": "x" * 500}), ValueError, "room"),
    (lambda r: r.restart(-1), ValueError, "seed"),
    (lambda r: r.restart(1.5), TypeError, "seed = 1.5: must be a whole number"),
    (lambda r: r.restore(None), TypeError, r"snapshot = None: must be what snapshot\(\) returned"),
    (lambda r: r.topic("walk_to_request"), gaitway.NothingPublished, "nothing"),
    (lambda r: r.__reduce__(), TypeError, "pickled"),
])
def test_calls(robot, call, error, tells):
    with pytest.raises(error, match=tells):
        call(robot)
    before = robot.time_s
    robot.run(0.01)
    assert robot.time_s == pytest.approx(before + 0.01)


@pytest.mark.parametrize(("arguments", "error", "tells"), [
    ({"robot": "humanoid2"}, ValueError, "humanoid22"),
    ({"robot": "/no/such/folder"}, ValueError, "no/such"),
    ({"config": "wlk"}, ValueError, "walk"),
    ({"world": "boxs"}, ValueError, "boxes"),
    ({"world_seed": 1}, ValueError, "world"),
    ({"seed": -1}, ValueError, "seed"),
    ({"seed": 2**64}, ValueError, "seed"),
    ({"seed": 1.5}, TypeError, "seed = 1.5: must be a whole number"),
    ({"robot": 1}, TypeError, "robot = 1: must be a path or a name"),
    ({"world": b"\xff"}, TypeError, "world = .*must be a path or a name, in UTF-8"),
    ({"libraries": [3]}, TypeError, "libraries = 3: must be a path or a name"),
    ({"conditions": {"slope_deg": [NAN, 0]}}, ValueError, "conditions = .*numbers must be finite"),
    ({"mismatch": NAN}, ValueError, "mismatch"),
    ({"mismatch": 11}, ValueError, "mismatch"),
    ({"conditions": {"slope": 3}}, ValueError, "slope"),
    ({"parameters": {"trajectry": {"lift": 1}}}, ValueError, "trajectory"),
    ({"parameters": {"trajectory": {"no_such": 1}}}, (ValueError, gaitway.PluginError), "no_such"),
    ({"parameters": {"trajectory": 3}}, TypeError, "'trajectory': 3: must be {plug-in: {parameter: value}}"),
    ({"parameters": 3}, TypeError, "parameters = 3: must be {plug-in"),
    ({"parameters": {3: {}}}, TypeError, "parameters: 3"),
    ({"parameters": {"trajectory": {3: 1}}}, TypeError, "trajectory: a parameter goes by its name, a str; not by 3"),
    ({"writes": "correction"}, TypeError, r"writes = 'correction': must be a list, such as \['correction'\]"),
    ({"writes": 3}, TypeError, "writes = 3: must be a list"),
    ({"libraries": "libsway.so"}, TypeError, "libraries = 'libsway.so': must be a list"),
    ({"libraries": pathlib.Path("libsway.so")}, TypeError, "must be a list"),
    ({"writes": ["corection"]}, KeyError, "correction"),
    ({"libraries": ["/no/such.so"]}, (ValueError, gaitway.PluginError), "no/such"),
    ({"profile": "papr"}, ValueError, "paper"),
])
def test_robots_that_cannot_be(arguments, error, tells):
    with pytest.raises(error, match=tells):
        gaitway.Robot(**arguments)


def test_after_close():
    robot = gaitway.Robot()
    robot.run(0.2)
    view, snapshot = robot.view("imu"), robot.snapshot()
    robot.close()
    robot.close()
    assert robot.closed and "closed" in repr(robot)
    assert view["stamp_ns"] > 0
    for call in (lambda: robot.run(0.1), lambda: robot.walk(0.1), lambda: robot.topic("imu"), robot.snapshot, robot.events, robot.truth,
                 lambda: robot.restore(snapshot), lambda: robot.view("estimate"), lambda: robot.fallen, lambda: robot.digest):
        with pytest.raises(gaitway.ClosedError, match="closed"):
            call()


def test_two_threads_with_one_robot():
    robot = gaitway.Robot()
    thread = threading.Thread(target=lambda: robot.run(3.0))
    thread.start()
    told = None
    while thread.is_alive() and told is None:
        try:
            robot.run(0.001)
        except gaitway.BusyError as error:
            told = str(error)
        time.sleep(0.001)
    thread.join()
    assert told is not None and "another thread" in told
    robot.run(0.01)


FORK = """
import os, sys
import gaitway
robot = gaitway.Robot(seed=4)
robot.run(0.3)
vec = gaitway.make_vec(2, threads=2)
vec.reset(seed=1)
digest, view = robot.digest, robot.view("imu")
child = os.fork()
if child == 0:
    told = 0
    for call in (lambda: robot.run(0.1), robot.truth, lambda: vec.reset(seed=1), lambda: robot.topic("imu")):
        try:
            call()
        except gaitway.ForkError as error:
            told += "forked" in str(error)
    robot.close()
    del robot, vec
    with gaitway.Robot(seed=4) as own:
        own.run(0.3)
        sys.exit(0 if told == 4 and own.digest == digest and view["stamp_ns"] > 0 else 3)
_, status = os.waitpid(child, 0)
assert os.waitstatus_to_exitcode(status) == 0, status
assert robot.digest == digest
robot.run(0.3)
vec.step(vec.action_space.sample() * 0.1)
"""


def test_fork():
    subprocess.run([sys.executable, "-c", FORK], check=True, timeout=120)


def busy_of(work, times):
    """How often two threads that do the same work at once are told that somebody else is at it."""
    told = []

    def again():
        for _ in range(times):
            try:
                work()
            except gaitway.BusyError:
                told.append(1)

    threads = [threading.Thread(target=again) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return len(told)


def test_a_vector_is_for_one_thread_at_a_time():
    vec = gaitway.make_vec(2, observation=["estimate"], threads=2, episode_s=0.08)
    vec.reset(seed=1)
    assert busy_of(lambda: vec.step(np.zeros((2, 3))), 6) > 0
    assert len({env.robot.time_s for env in vec.envs}) == 1, "a step is of all or of none"
    vec.close()


def test_a_reward_does_not_step_its_own_vector():
    vec = gaitway.make_vec(2, observation=["estimate"], reward=lambda _: vec.step(np.zeros((2, 3))))
    vec.reset(seed=1)
    with pytest.raises(gaitway.BusyError):
        vec.step(np.zeros((2, 3)))
    vec.close()


def test_a_pool_is_for_one_thread_at_a_time():
    pool = gaitway._native.Pool(2)
    robots = [gaitway.Robot(seed=seed) for seed in (1, 2, 3, 4)]
    halves = iter([[robots[0]._run, robots[1]._run], [robots[2]._run, robots[3]._run]])
    mine = threading.local()

    def work():
        if not hasattr(mine, "runs"):
            mine.runs = next(halves)
        pool.advance(mine.runs, 40)

    assert busy_of(work, 20) > 0
    for robot in robots:
        robot.close()


DAEMONS = """
import os, sys, threading, gaitway
at_work = threading.Barrier(5)
def endless(work):
    def again():
        work()
        at_work.wait()
        while True:
            work()
    threading.Thread(target=again, daemon=True).start()
robot, other = gaitway.Robot(seed=1), gaitway.Robot(seed=2)
vec = gaitway.make_vec(2, threads=2, observation=["estimate"])
vec.reset(seed=1)
endless(lambda: robot.run(0.5))
endless(lambda: other.restart(3))
endless(lambda: gaitway.Robot(seed=4))
endless(lambda: vec.step([[0.1, 0.0, 0.0]] * 2))
at_work.wait()
child = os.fork()
if child == 0:
    sys.exit(3)  # it has none of these threads, and waits for none
assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 3
"""


def test_daemon_threads_do_not_take_an_ending_interpreter_along():
    ended = subprocess.run([sys.executable, "-c", DAEMONS], check=False, capture_output=True, text=True, timeout=120)
    assert (ended.returncode, ended.stdout, ended.stderr) == (0, "", "")


AT_EXIT = """
import atexit
def last():
    robot.run(0.1)
    print(robot.time_s)
atexit.register(last)  # called after what gaitway registers when it is loaded
import gaitway
robot = gaitway.Robot()
"""


def test_the_thread_that_ends_the_interpreter_may_still_run_robots():
    ended = subprocess.run([sys.executable, "-c", AT_EXIT], check=True, capture_output=True, text=True, timeout=120)
    assert ended.stdout.split() == ["0.1"] and ended.stderr == ""


def test_restore_is_interrupted(robot):
    robot.restart(1)
    robot.run(4.0)
    snapshot, digest, view = robot.snapshot(), robot.digest, robot.view("imu")

    def interrupt(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.1)
        with pytest.raises(KeyboardInterrupt):
            robot.restore(snapshot)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert robot.time_s < 4.0, "it went on to the end"
    assert view["stamp_ns"] <= robot.time_s * 1e9
    robot.restore(snapshot)
    assert robot.digest == digest


def test_a_view_of_nothing_is_no_buffer():
    with pytest.raises((BufferError, TypeError)):
        memoryview(gaitway._native.View.__new__(gaitway._native.View))


FORK_WHILE_LOADING = """
import os, threading, time, gaitway
robot, stop = gaitway.Robot(seed=1), threading.Event()
def again():
    while not stop.is_set():
        robot.restart(1)
thread = threading.Thread(target=again)
thread.start()
children = []
for _ in range(6):
    time.sleep(0.05)
    child = os.fork()
    if child == 0:
        gaitway.Robot(seed=9).close()
        os._exit(0)
    children.append(child)
stop.set()
thread.join()
assert all(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0 for child in children)
"""


def test_a_fork_while_another_thread_loads():
    subprocess.run([sys.executable, "-c", FORK_WHILE_LOADING], check=True, timeout=120)


def test_a_crashing_plugin_is_refused_by_name():
    with pytest.raises((gaitway.PluginError, ValueError), match="crash"):
        gaitway.Robot(libraries=[os.environ["GAITWAY_CRASHING_PLUGIN"]])


def test_import_does_nothing():
    code = ("import threading, signal; import gaitway; gaitway.Robot\n"
            "assert threading.active_count() == 1\nassert signal.getsignal(signal.SIGINT) is signal.default_int_handler\n"
            "import sys; assert 'gymnasium' not in sys.modules")
    subprocess.run([sys.executable, "-c", code], check=True)


def test_without_gymnasium():
    code = ("import sys; sys.modules['gymnasium'] = None\nimport gaitway\ngaitway.Robot\n"
            "try:\n    gaitway.Env\nexcept ImportError as error:\n    assert 'gaitway[gym]' in str(error)\nelse:\n    sys.exit(1)\n"
            "try:\n    gaitway.make_vec\nexcept ImportError as error:\n    assert 'gaitway[gym]' in str(error)\nelse:\n    sys.exit(1)")
    subprocess.run([sys.executable, "-c", code], check=True)


def test_names_of_the_package():
    with pytest.raises(AttributeError, match="no_such"):
        gaitway.no_such
    assert all(getattr(gaitway, name) is not None for name in gaitway.__all__)
    assert gaitway.__version__ == "0.1.0"
