"""A plug-in in Python is a plug-in like any other: the same bits as in C++, and whatever is wrong with it is refused by name
before anything moves, or is a fault of one step while the robot stands."""

import os
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest

import gaitway

ROOT = pathlib.Path(__file__).parents[2]
SEED = 3

# Reads, and writes what nobody else does. What is put in place of BODY is its step.
PLUGIN = """
import gaitway.plugin as gp

class Own(gp.Plugin):
    '''Does what a test wants.'''
    DECLARED
    def __init__(self, setup):
        self.gain = setup.parameter("gain", 0.5, "rad/rad", lowest=0.0, highest=2.0, doc="how strongly")
        self.estimate = setup.reads("estimate")
        self.trim = setup.writes("trim")
        self.correction = setup.writes("correction")
        self.steps = 0
        self.report = setup.reporter()
        MORE

    def step(self, tick):
        self.steps += 1
        trim = self.trim.value
        trim["channel_count"], trim["stamp_ns"] = 8, tick.now_ns
        BODY
        self.trim.publish()
        self.correction.publish()
"""


def write(folder, body="pass", more="pass", declared="", name="own.py"):
    file = folder / name
    file.write_text(PLUGIN.replace("BODY", body).replace("MORE", more).replace("DECLARED", declared))
    return file


def configuration(folder, balance, **keys):
    """The walk with another plug-in for its balance."""
    lines = "".join(f"    {key}: {value}\n" for key, value in keys.items())
    file = folder / "own.yaml"
    file.write_text(f"plugins:\n  - name: zmp\n  - name: trajectory\n  - name: own\n    library: {balance}\n{lines}  - name: kinematics\n")
    return file


def walked(file, seconds=2.0):
    with gaitway.Robot(config=file, seed=SEED) as robot:
        robot.run(0.5)
        robot.walk(0.1)
        robot.run(seconds - 0.5)
        return robot.digest, robot.faults(), robot.topic("trim")


def stood(file, seconds=1.0):
    """Events of a robot that only stands, and still does at the end."""
    with gaitway.Robot(config=file, seed=SEED) as robot:
        robot.run(seconds)
        assert not robot.fallen
        assert robot.batches().handed_over > 5
        return robot.events(), {fault.plugin: fault for fault in robot.faults()}


def test_the_same_bits_as_in_cpp(tmp_path):
    python = configuration(tmp_path, ROOT / "python" / "examples" / "ankle_trim.py")
    first, faults, trim = walked(python)
    assert [fault.faults for fault in faults] == [0, 0, 0, 0]
    assert np.count_nonzero(trim["angle"]) == 4
    assert walked(python)[0] == first
    assert walked(configuration(tmp_path, "libgaitway_plugin_ankle_trim.so"))[0] == first
    assert walked(configuration(tmp_path, write(tmp_path)))[0] != first


def test_in_the_place_of_the_shipped_one(tmp_path, command):
    """`--with`, `libraries` and `gaitway plugins` take a file as they take a library; it imports what lies beside it."""
    (tmp_path / "law.py").write_text("def angle(gain, lean):\n    return gain * lean\n")
    file = write(tmp_path, "import law; trim['angle'][4:6] = law.angle(self.gain, self.estimate.read()['attitude'][1])")
    with gaitway.Robot(seed=SEED, libraries=[file], parameters={"own": {"gain": "0.3 rad/rad"}}) as robot:
        assert "stability" not in {fault.plugin for fault in robot.faults()}
        robot.run(0.5)
        assert [fault.faults for fault in robot.faults()] == [0, 0, 0, 0]
    said = subprocess.run([command, "run", "--with", file, "--seconds", "0.3", "--out", tmp_path / "out", "--no-pictures"], check=True,
                          capture_output=True, text=True).stdout
    assert "own (" in said and "replaces stability" in said
    listed = subprocess.run([command, "plugins", file], check=True, capture_output=True, text=True).stdout
    assert "own 0.0.0  Does what a test wants." in listed
    assert "gain = 0.5 rad/rad  how strongly" in listed
    assert not list(tmp_path.rglob("__pycache__"))


@pytest.mark.parametrize(("body", "tells"), [
    ("1 / (self.steps - 1)", r"own\.py:\d+ in step: ZeroDivisionError: division by zero"),
    ("np = __import__('numpy'); np.linalg.inv(np.zeros((2, 2)))", r"own\.py:\d+ in step: LinAlgError: Singular matrix"),
    ("trim['angle'][0] = float('nan')", r"topic 'trim': field 'angle'\[0\]\[0\] is not finite"),
    ("trim['angle'][0] = 100.0", r"field 'angle'\[0\]\[0\] is 100; it must lie between"),
    ("self.estimate.read()['fall'] = 1", "read-only"),
    ("__import__('os').fork()", "called (fork|clone), which a plug-in in a process of its own may not"),
    ("__import__('socket').socket()", "called socket, which"),
    ("bytearray(1 << 30)", "MemoryError"),
])
def test_faults_of_a_step(tmp_path, body, tells):
    """Each is told once a step, its fallback stands in, and the robot stands."""
    events, faults = stood(configuration(tmp_path, write(tmp_path, body)), 0.6)
    told = [event.text for event in events if event.kind == "fault" and event.source == "own"]
    assert any(re.search(tells, text) for text in told), events
    assert faults["own"].faults > 0


@pytest.mark.parametrize(("body", "tells"), [
    ("while self.steps == 5: pass", "did not answer within"),
    ("self.steps == 5 and __import__('sys').exit(7)", "exited with code 7 in its step"),
    ("self.steps == 5 and __import__('ctypes').string_at(0)", "was ended by SIGSEGV in its step"),
    ("self.steps == 5 and __import__('subprocess').run(['true'])", "was ended by SIGSYS in its step"),  # it blocks all signals
])
def test_a_lost_process_is_replaced(tmp_path, body, tells):
    """From the state of its last good step: it has counted on, and so does not fail again."""
    declared = """state_version = 1
    def save_state(self): return self.steps.to_bytes(4, "little")
    def restore_state(self, state): self.steps = int.from_bytes(state, "little") + 1
"""
    events, faults = stood(configuration(tmp_path, write(tmp_path, body, declared=declared)), 0.6)
    texts = [event.text for event in events if event.source == "own"]
    assert any(tells in text for text in texts), events
    assert any("runs in a new process, from the state of its last good step" in text for text in texts), events
    assert 0 < faults["own"].faults < 10


def test_a_state_that_cannot_be_handed_on_is_told(tmp_path):
    declared = """state_version = 1
    def save_state(self): return "text"
"""
    events, faults = stood(configuration(tmp_path, write(tmp_path, declared=declared)), 0.6)
    told = [event.text for event in events if event.source == "own" and "hands no state on any more" in event.text]
    assert len(told) == 1, events
    assert faults["own"].faults == 0


def test_threads_of_a_plugin_may_be_there_to_the_end(tmp_path):
    """They report while its process ends, which waits for none of them."""
    more = """__import__("threading").Thread(target=lambda: [self.report("info", "hum") for _ in iter(int, 1)], daemon=True).start()"""
    file = write(tmp_path, more=more)
    for _ in range(4):
        with gaitway.Robot(libraries=[file], seed=SEED) as robot:
            robot.run(0.1)
            assert not [event for event in robot.events() if "was ended by" in event.text]


def test_who_is_lost_too_often_is_out_of_service(tmp_path):
    events, _ = stood(configuration(tmp_path, write(tmp_path, "self.steps == 2 and __import__('os')._exit(1)")), 0.6)
    assert any("was replaced 3 times within 10 s" in event.text for event in events), events


@pytest.mark.parametrize(("text", "error", "tells"), [
    ("import gaitway.plugin as gp\nclass Own(gp.Plugin)\n", gaitway.PluginError, r"own\.py:2: SyntaxError"),
    ("import no_such_module\n", gaitway.PluginError, r"own\.py:1 in <module>: ModuleNotFoundError: No module named 'no_such_module'"),
    ("", gaitway.PluginError, "must hold one class .* holds none"),
    ("import gaitway.plugin as gp\nclass A(gp.Plugin): pass\nclass B(gp.Plugin): pass\n", gaitway.PluginError, "holds A, B"),
    ("import gaitway.plugin as gp\nclass Own(gp.Plugin): version = 1.0\n", gaitway.PluginError, r"own\.py: Own\.version = 1\.0: must be a text"),
    ("raise SystemExit(5)\n", gaitway.PluginError, "exited with code 5 while it constructed"),
    (("setup.reads('estimat')",), gaitway.PluginError, r"own\.py:\d+ in __init__: UnknownTopic: .*Did you mean 'estimate'"),
    (("setup.reads('estimate', [('x', 'f8')])",), gaitway.PluginError, "TypeError: topic 'estimate' is a standard one"),
    (("setup.reads('sway', 'f8')",), gaitway.PluginError, "no fields"),
    (("setup.reads('sway', [('x', 'O')])",), gaitway.PluginError, "must be a number"),
    (("setup.reads('sway', [('x', 'f8')])",), gaitway.PluginError, "reads topic 'sway', but nobody writes it"),
    (("setup.writes('sway', [('x', 'f8')]); setup.reads_previous('sway', [('x', 'f4')])",), gaitway.PluginError, "type hash"),
    (("setup.writes('trim')",), gaitway.PluginError, "twice"),
    (("setup.parameter('a', None)",), gaitway.PluginError, "own.py:.*a parameter's default is a float, an int, a bool or a str"),
    (("setup.period('second')",), gaitway.PluginError, "must be one of tick, batch"),
    (("self.estimate.read()",), gaitway.PluginError, "has no values before activate"),
    (("self.correction.publish()",), gaitway.PluginError, "is for step.. only"),
])
def test_refusals_before_anything_moves(tmp_path, text, error, tells):
    file = tmp_path / "own.py"
    if isinstance(text, tuple):
        write(tmp_path, more=text[0])
    else:
        file.write_text(text)
    with pytest.raises(error, match=tells):
        gaitway.Robot(config=configuration(tmp_path, "./own.py"))


@pytest.mark.parametrize(("keys", "tells"), [
    ({"isolation": "none"}, "must be 'process' for a plug-in in Python"),
    ({"parameters": "{gain: 3 rad/rad}"}, r"own\.yaml:6.*must be 0\.\.2|gain"),
    ({"parameters": "{gian: 1}"}, "gian"),
])
def test_configurations(tmp_path, keys, tells):
    write(tmp_path)
    with pytest.raises(gaitway.InputError, match=tells):
        gaitway.Robot(config=configuration(tmp_path, "./own.py", **keys))


def test_a_missing_file(tmp_path):
    write(tmp_path)
    with pytest.raises(gaitway.PluginError, match="no library 'own.py'.*Write './' before"):
        gaitway.Robot(config=configuration(tmp_path, "own.py"))


def test_topics_of_ones_own_and_every_life(tmp_path):
    """Two plug-ins in Python share a topic that no schema has; both ends of a life, reports, prints, and no step between batches."""
    value = "[('x_m', 'f8', (3,)), ('count', 'u4')]"
    write(tmp_path, "self.sway.value['count'] = self.steps; self.sway.publish()", f"self.sway = setup.writes('sway', {value})")
    (tmp_path / "reader.py").write_text(f"""
import gaitway.plugin as gp
class Reader(gp.Plugin):
    def __init__(self, setup):
        setup.period("batch")
        self.sway = setup.reads("sway", {value})
        self.report = setup.reporter()
    def activate(self): self.report("info", "is there")
    def step(self, tick):
        assert tick.batch and self.sway.has_value and self.sway.age_ns(tick.now_ns) == 0
        self.report("warning", f"{{self.sway.read()['count']}} {{self.sway.sequence}}")
    def deactivate(self): print("is gone", flush=False)
""")
    with configuration(tmp_path, "./own.py").open("a") as file:
        file.write("  - name: reader\n    library: ./reader.py\n")
    script = f"import gaitway\nwith gaitway.Robot(config={str(tmp_path / 'own.yaml')!r}) as r:\n  r.run(0.4)\n  print(r.events(), r.faults())\n"
    ran = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True)
    assert "is there" in ran.stdout and "is gone" in ran.stdout, ran
    told = re.findall(r"'(\d+) (\d+)'", ran.stdout)
    assert len(told) == 5 and all(count == sequence for count, sequence in told) and told == sorted(told, key=lambda pair: int(pair[0])), ran


def test_a_wrong_interpreter(tmp_path):
    """Told by name, before anything moves."""
    file = configuration(tmp_path, write(tmp_path))
    script = f"import gaitway; gaitway.Robot(config={str(file)!r})"
    for interpreter, tells in (("/no/such/python", "cannot be run: No such file"), ("/usr/bin/python3", "GAITWAY_PYTHON")):
        if interpreter == "/usr/bin/python3" and subprocess.run([interpreter, "-c", "import numpy"], check=False, capture_output=True).returncode == 0:
            continue
        ran = subprocess.run([sys.executable, "-c", script], check=False, capture_output=True, text=True,
                             env={**os.environ, "GAITWAY_PYTHON": interpreter})
        assert ran.returncode == 1
        assert "PluginError" in ran.stderr and tells in ran.stderr, ran.stderr


def test_a_sweep_knows_a_changed_plugin(tmp_path):
    """What its trials depend on is the configuration, the plug-in that it names, and what that may import."""
    from gaitway.sweep.robot_trial import content_of

    file = configuration(tmp_path, "./" + write(tmp_path).name)
    contents = [content_of("config", str(file))]
    for name, text in (("own.py", "# changed"), ("law.py", "pass"), ("law.py", "pass  # changed")):
        (tmp_path / name).write_text(text)
        contents.append(content_of("config", str(file)))
    assert len(set(contents)) == len(contents)
    (tmp_path / "notes.txt").write_text("nothing")
    assert content_of("config", str(file)) == contents[-1]
