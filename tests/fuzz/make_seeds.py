#!/usr/bin/env python3
"""Writes the fuzz targets' seeds, from the frames of a recorded run and the shipped files.

    python3 tests/fuzz/make_seeds.py out/run/bus.log

To be run again when a message's layout or a target's way of taking its input apart has changed. What each
number means stands in the target of the same name.
"""
import pathlib
import re
import struct
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORPUS = pathlib.Path(__file__).resolve().parent / "corpus"
KINDS = ("emergency_stop", "user_command", "sync", "trim", "feedback", "fault_report", "trajectory",
         "resynchronisation", "heartbeat", "tail")
SIZES = (1, 4, 4, 8, 8, 1, 8, 8, 5, 8)


def write(target, name, content):
    folder = CORPUS / target
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())


def words(*values):
    return b"".join(struct.pack("<f" if isinstance(value, float) else "<I", value) for value in values)


def frame(identifier, data, extended=False, remote=False):
    """As take_frame() in fuzz_frame.hpp reads it."""
    return struct.pack("<BI", extended | remote << 1 | len(data) << 4, identifier) + (b"" if remote else data)


def known(kind, data, toggle=False, part=0):
    """As take_known_frame() reads it, after the node."""
    index = KINDS.index(kind)
    return bytes([index, toggle, part]) + data.ljust(SIZES[index], b"\0")


def recorded(log):
    lines = log.read_text().splitlines()
    frames = [(int(match[1], 16), bytes.fromhex(match[2]))
              for match in (re.search(r" ([0-9A-F]{3})#([0-9A-F]*)$", line) for line in lines) if match]
    return lines, frames


def first_of_each_kind(frames):
    bases = {0x008: "sync", 0x010: "trim", 0x047: "feedback", 0x10E: "trajectory", 0x300: "heartbeat"}
    found = {}
    for identifier, data in frames:
        if identifier in bases and (any(data) or identifier == 0x300):
            found.setdefault(bases[identifier], (identifier, data))
    return found


def bus_seeds(lines, frames):
    moving = lines[len(lines) // 2:]
    write("candump_log", "walking", "\n".join(moving[:12]) + "\n")
    write("candump_log", "other_writers", "(0001.500000) vcan0 10f#00ff7f\n\n(1.500001) slcan0 7FF#\n")
    write("candump_log", "other_formats", "(1.000000) can0 1FFFFFFF#0102\n(1.000001) can0 123#R4\n"
                                          "(1.000002) can0 20000004#0004000000000000\n")
    for name, (identifier, data) in first_of_each_kind(frames).items():
        one = frame(identifier, data)
        write("can_messages", name, b"\0" + one + bytes(range(1, 60)))
        write("frame_length", name, one)
        write("frame_reader", name, one + b"\0")
    write("can_messages", "paper_profile", b"\1" + frame(25, bytes([7, 1, 2, 3])) + bytes(range(60)))
    write("frame_length", "all_zero", frame(0, bytes(8)))
    write("frame_length", "extended", frame(0x1FFFFFFF, b"\1\2\3", extended=True))
    write("frame_length", "remote", frame(0x123, b"", remote=True))
    write("frame_reader", "extended", frame(0x12345678, b"\x0F\x1F", extended=True) + b"\2\x20\x30" + bytes(range(20)))
    record = bytes([1]) + frame(0x123, b"\1\2") + b"\0"           # transmit
    mark = bytes([2]) + frame(0, b"") + b"\0" + b"\x20"
    write("bus_socket", "transmits", bytes([0, 1, 5, 0, 1]) + record + b"\0" + record + b"\x10" + bytes([3, 40]) +
          bytes([5, 0, 0]) + mark + bytes([3, 200, 2, 0, 3, 10]))
    write("bus_socket", "no_greeting", bytes([0, 0, 1, 0, 40]) + bytes(40) + bytes([3, 1]))
    write("socketcand_protocol", "raw_mode",
          b"\3\7\1\0< open can0 >< rawmode >< send 123 2 1a ff >< echo >< statistics 100 >")
    write("socketcand_protocol", "bcm",
          b"\xff\0\0\0< add 0 500000 12345678 8 11 22 33 44 55 66 77 88 >< subscribe 0 0 7FF ><filter 1 0 0A1 1 ff>"
          b"< delete 123 >< can0 B 1 2 3 >")


def mail_seeds():
    trim = words(1, 0, 8) + words(*[0.01 * i for i in range(8)]) + words(0.5)  # the last one: softness
    write("small_mails", "trim", b"\1" + trim + words(0))
    write("small_mails", "user_command", b"\1" + words(1, 3, 7, 0.25, 50, 0))
    write("small_mails", "answer", b"\1" + words(0, 12, 2, 7, 3, 5, 1.5, 0))
    small = words(0x47570001, 12, 1 | 8 << 16, 0.0, 0.0, 0xAAAA) + words(*[0.001 * i for i in range(8)]) + words(0)
    gains = [0.25] * 12
    wide = words(0x47570001, 13, 2 | 1 << 8 | 9 << 16, 0.0, 0.1, *gains, 0x12415, *[0.01 * i for i in range(18)], 0)
    write("hand_over", "one_joint", b"\1" + small)
    write("hand_over", "two_joints", b"\1" + wide)
    post = b"\1" + struct.pack("<H", len(small) // 4) + small + b"\0"
    write("emi_window", "mad_host", b"\0" + b"\0" + post + b"\2\1\6\0" + words(1, 0, 0, 0.0, 0, 0) + b"\0" +
          b"\1\1\x0d\0" + trim + words(0) + b"\0")
    write("emi_window", "mad_message_controller", b"\1" + (b"\1\x08\0" + words(0, 12, 0, 0, 1, 1, 0.0, 0) + b"\0\0\1") * 2)


def block_seeds():
    request = bytes([3, 0, 7, 0, 1, 1, 0, 9, 0, 0, 1])  # client 0 opens "zmp" to write
    write("block_requests", "open", request + bytes([3, 0, 7, 0, 2, 0, 0, 6, 1, 4, 0]) + b"\0" + request)
    write("block_requests", "bare_bytes", bytes([2, 0, 20, 0]) + bytes(range(20)) + request)
    write("block_answers", "memory", bytes([1, 7, 1]) + bytes(8) + bytes([1, 1, 0]))
    write("block_answers", "announced_only", bytes([2, 7, 1]) + bytes(8) + bytes([1, 1, 0]))
    row = bytes([4]) + bytes(8) + bytes(4) + b"\1" + bytes(4) + b"\5\6" + bytes(12) + b"\3"
    write("topic_directory", "two_rows", bytes([0, 0, 16, 0, 2]) + row + row + struct.pack("<HQ", 5, 96))
    write("child_messages", "parameter", words(7) + words(3) + bytes(8) + b"gain of the ankle".ljust(200) +
          bytes([0, 2, 3, 1]) * 4 + words(6, 4) + b"gain" + words(3) + bytes(16) + words(2) + b"up")
    topic = b"\1\0" + b"zmp".ljust(20, b"\0") + b"\1\3\1\1"
    gain = b"\1\1" + b"gain".ljust(20, b"\0") + b"\0"
    created, attached = b"\1\3", b"\1\5" + words(12) + b"\0"
    write("child_start_up", "in_order", topic + gain + b"\1\2\1" + b"\0\2\0" + created + attached)
    write("child_start_up", "attached_before_created", topic + attached + created)
    write("child_start_up", "topic_after_created", created + topic + attached)


def controller_seeds(frames):
    kinds = first_of_each_kind(frames)
    batch = known("trajectory", kinds["trajectory"][1])
    sync = known("sync", bytes([1, 0, 0x08]))
    play = b"\7" + batch + b"\7" + sync + b"\3\x0a" + b"\7" + known("sync", bytes([1, 0, 0x09])) + b"\3\x28"
    trim = b"\7" + known("trim", kinds["trim"][1])
    repair = b"\7" + known("resynchronisation", bytes([0x10, 0, 3, 1, 2, 3, 4, 5]))
    sensors = b"\1" + struct.pack("<iff", 2000, 1.5, -0.25)
    write("joint_controller", "plays_a_batch", b"\0\3" + sensors + play + trim + b"\3\x3f")
    write("joint_controller", "is_repaired_and_stopped",
          b"\0\1" + play + repair + b"\3\x0a" + b"\7" + known("emergency_stop", b"\1") + b"\3\x05\5\3\x05")
    write("joint_controller", "paper_profile", b"\1\0" + b"\7" + batch + b"\3\x3f" + b"\7" +
          known("user_command", bytes([7, 50, 0, 9])) + b"\4" + struct.pack("<I", 3_000_000))
    feedback = known("feedback", kinds["feedback"][1])
    write("network_watch", "feedback_and_silence",
          b"\0" + (b"\0\7\0" + feedback) * 3 + b"\0\0\0\0" + b"\7\0" + feedback + b"\7\1" + batch)
    write("network_watch", "strangers", b"\0\0" + b"\3" + frame(0x555, b"\1") + b"\3" + frame(0x47, b"\1\2") + b"\3" +
          frame(0x1234567, b"", extended=True) + b"\4" + frame(0x41, b"", remote=True) + b"\2\2\xff\0")
    step = b"\7\x27"
    hand_over = b"\2\0\x08\2\0" + b"\2" + struct.pack("<HBb", 5, 0, 3) + struct.pack("<HBb", 30, 0, -3)
    command = b"\3" + words(1) + b"\3\4\1" + words(0.05) + b"\x40\0"
    write("message_controller", "plays_a_batch", b"\0" + step * 2 + hand_over + step * 3 + b"\5\6" + feedback + step)
    write("message_controller", "moves_a_joint_and_stops",
          b"\0" + step + command + step + b"\3" + words(2) + b"\1\0\0\0\0" + step)
    write("message_controller", "trims", b"\0" + step + b"\4\x08" + words(*[0.01] * 8) + step)
    write("message_controller", "paper_profile", b"\1" + step + hand_over + step * 3 + b"\1\2\xff" + step)


def text_seeds():
    write("scenario_file", "everything", (
        "seconds: 20\nevents:\n  - {at_s: 1.0, walk: [0.15, 0.0, 0.1]}\n  - {at_s: 8.0, stand: true}\n"
        "  - {at_s: 8.2, motion: wave}\n  - {at_s: 8.4, leave_motion: true}\n"
        "  - {at_s: 9, push: {body: trunk, direction: [0, 1, 0], impulse_Ns: 1.0, duration_s: 0.1}}\n"
        "  - {at_s: 9.5, emergency_stop: soft}\n  - {at_s: 12.0, fault: {kind: main_controller_silent, duration_s: 3}}\n"
        "  - {at_s: 3, fault: {kind: lose_frames, probability: 0.02, duration_s: 2.0}}\n"
        "  - {at_s: 17.0, fault: {kind: plugin_fails, plugin: zmp, how: overruns, cost_s: 0.01}}\n  - {at_s: 1, stop: true}\n"))
    write("scenario_file", "bus_faults", (
        "seconds: 9\nevents:\n"
        "  - {at_s: 1, fault: {kind: disturb_bus, corruption: 0.01, omission: 0.001, duplicate: 0.001, duration_s: 6}}\n"
        "  - {at_s: 2, fault: {kind: jam, duration_s: 0.002, stuck: true}}\n"
        "  - {at_s: 3, fault: {kind: bus_off, node: message_controller}}\n"
        "  - {at_s: 4, fault: {kind: joint_restarts, joint: left_knee, duration_s: 0.02}}\n"
        "  - {at_s: 5, fault: {kind: foreign_frame, id: 0x7AB, data: [1, 2, 3], extended: true}}\n"
        "  - {at_s: 6, fault: {kind: foreign_frame, id: 1, remote: true}}\n"))
    write("scenario_file", "camera_faults", (
        "seconds: 9\nevents:\n"
        "  - {at_s: 1, fault: {kind: camera_fails, camera: left, how: dead, duration_s: 3}}\n"
        "  - {at_s: 2, fault: {kind: camera_fails, how: turned, turn_deg: [1, 0, -0.5]}}\n"
        "  - {at_s: 3, fault: {kind: camera_fails, how: dropped, share: 0.3}}\n"
        "  - {at_s: 4, fault: {kind: camera_fails, how: late, later_s: 0.2}}\n"
        "  - {at_s: 5, fault: {kind: camera_fails, camera: both, how: exchanged}}\n"))
    yaml = (ROOT / "urdf/humanoid22/robot.yaml").read_text()
    yaml = re.sub(r" *#[^\n]*", "", yaml).replace(
        "{profile: full}", "{profile: full, messages: {trajectory: {id: 0x120, deadline_ms: 15}, trim: {period_ms: 10}}}")
    write("network_file", "humanoid22", re.sub(r"\n\n+", "\n", re.sub(r"(?<=,) {2,}", " ", yaml)))
    yaml = (ROOT / "urdf/humanoid22/camera.yaml").read_text()
    write("camera_file", "humanoid22", re.sub(r" *#[^\n]*", "", yaml).lstrip())
    write("message_list", "three_messages", (
        '[{"name": "brake", "id": 16, "bytes": 8, "period_us": 2500, "jitter_us": 0.5, "deadline_us": 2500},\n'
        ' {"name": "a", "id": 17, "bytes": 0, "period_us": 350, "jitter_us": 0, "deadline_us": 325, "fifo": "engine"},\n'
        ' {"name": "b", "id": 536870911, "extended": true, "bytes": 1, "period_us": 1e4, "jitter_us": 1, "deadline_us": 9e3}]\n'))
    write("error_option", "burst", "burst:4,interval:10ms")
    write("error_option", "jam", "jam:2.5e3us,interval:0.1s")
    write("urdf_file", "two_links", (
        '<robot name="r"><material name="m"><color rgba="1 0 0 1"/></material>\n'
        '<link name="a"><inertial><origin xyz="0 0 1" rpy="0 0 0"/><mass value="1"/>'
        '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>\n'
        '<visual><geometry><sphere radius="1"/></geometry><material name="m"/></visual>'
        '<collision><geometry><box size="1 1 1"/></geometry></collision></link>\n'
        '<link name="b"><inertial><mass value="1"/>'
        '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>\n'
        '<joint name="j" type="revolute"><parent link="a"/><child link="b"/><origin xyz="0 0 1"/><axis xyz="0 1 0"/>'
        '<limit lower="-1" upper="1" effort="8" velocity="8"/></joint></robot>\n'))


def motion_seeds():
    def array(count, content):
        return struct.pack("<Q", count) + content

    def way(points):
        point = struct.pack("<18dQ", *([0.0] * 17), 0.0, 2)
        return array(points, point * points) + array(points, struct.pack("<f", 0.1) * points)

    def table(on_ground):
        return (b"GMOTION1" + array(4, b"wave") + array(0, b"") + struct.pack("<QQQ", 7, 1, on_ground) + way(17)
                + array(3, struct.pack("<IiIiIi", 0, -1, 0, 0, 0, -1)) + struct.pack("<Q", 1) + way(8))

    write("motion_table", "standing", table(0))
    write("motion_table", "on_ground", table(1))


def api_seeds():
    write("api_messages", "twist", '{"linear": {"x": 0.15, "y": 0, "z": 0.0}, "angular": {"x": 0, "y": 0, "z": -1e-1}}')
    write("api_messages", "move_joint", '{"joint": "left_knee", "position": 0.4, "duration": 1.5}')
    write("api_messages", "log", (
        '{"stamp": {"sec": 12, "nanosec": 5}, "level": 20, "name": "zmp", "msg": "\\u00e4 \\ud83e\\udd16", "line": 7.0}'))
    write("api_messages", "type_definition", (
        '{"type": "std_msgs/String", "fieldnames": ["data"], "fieldtypes": ["string"], "fieldarraylen": [-1, 0]}'))
    write("api_messages", "odometry", (
        '{"child_frame_id": "base", "pose": {"pose": {"orientation": {"w": 1}}, "covariance": [' + ", ".join(["0.5"] * 36) +
        ']}}'))
    write("api_messages", "broken_text", b'"\xc3\xa4\xff\xed\xa0\x80\xf4\x90\x80\x80\xe2\x82')


def say(client, message):
    """A known message of api_session.cpp, by its number there, unchanged."""
    return bytes([0, client, message, 1])


def conversation_seeds():
    wait, read = bytes([9, 0, 60]), bytes([13, 0, 31])
    publish = b"".join(bytes([11, 0, which, 22]) for which in range(4))
    heard = bytes([15, 0, 1, 1, 0, 0])
    write("api_session", "two_drivers", b"\0" + say(0, 0) + say(1, 0) + say(1, 15) + say(0, 0) + bytes([9, 0, 110]) +
          say(1, 1) + bytes([14, 1]) + say(2, 25) + bytes([13, 2, 5]) + say(2, 28) + say(1, 28) + say(2, 27) + say(0, 14))
    write("api_session", "subscriptions", b"\0" + b"".join(say(0, message) for message in range(5, 11)) + publish + read +
          publish * 3 + heard + wait + publish + read + say(0, 11) + say(0, 12) + say(0, 13) + publish + read * 2)
    write("api_session", "orders", b"\0" + b"".join(say(message % 3, message) for message in range(14, 33)) +
          bytes([12, 0, 0, 1, 4]) + b"done" + bytes([12, 0, 1, 0, 2]) + b"no" + heard + wait + read + bytes([13, 1, 31]))
    write("api_session", "token", b"\1" + say(0, 0) + say(0, 35) + say(0, 0) + say(1, 36) + say(1, 35) + say(2, 14) + heard +
          bytes([9, 0, 250]) * 3 + read)
    write("api_session", "flood", b"\0" + say(0, 0) * 60 + say(0, 16) + say(0, 33) * 60 + read)
    write("api_session", "own_words", b"\0" + bytes([8, 0, 13]) + b'{"op":"dance"}'[:13] + b"\1" + bytes([8, 1, 2]) + b"\xc3(" +
          b"\1" + bytes([8, 2, 4, 1, 2, 3, 4, 0]) + read)


def link_seeds():
    def order(payload, validity):
        return bytes([0, 3]) + struct.pack("<H", len(payload)) + payload + bytes([validity])

    def value(channel, content):
        return bytes([0, 4, channel]) + struct.pack("<H", len(content)) + content

    def said(kind, body, to_module):
        content = bytes([kind, 0, 0, 0, 0]) + body
        return bytes([1, 1, len(content) - 1]) + content + bytes([to_module])

    def wait(milliseconds):
        return bytes([0, 7, milliseconds])

    stop, silence = bytes([0, 5]), bytes([0, 6, 255])
    write("link_frames", "orders", order(b"walk", 200) + wait(3) + order(b"x" * 1000, 240) + wait(9) + order(b"late", 0) + wait(9))
    write("link_frames", "state_and_stops", value(0, b"small") + value(1, b"l" * 600) + stop + wait(5) + silence + value(1, b"n" * 300) +
          stop + wait(19) * 3)
    write("link_frames", "forged", order(b"walk", 200) + said(2, struct.pack("<qIBIHI", 1, 9, 0, 99, 3, 7), 0) +
          said(5, struct.pack("<IBB", 1, 0, 1) + struct.pack("<qH", 1 << 40, 1) + b"go", 0) +
          said(5, struct.pack("<IBB", 1, 0, 1) + struct.pack("<IBH", 1, 1, 0), 1) +
          said(6, struct.pack("<HBHIHB", 0, 1, 1, 16, 1, 8) + b"12345678", 1) + said(3, struct.pack("<6I", 1, 2, 3, 0, 0, 0), 0) + wait(9))
    write("link_frames", "strangers", bytes([0, 1, 72, 1]) + struct.pack("<IHBBQIQIQq", 0, 1, 2, 1, 9, 0, 1, 0, 3, 5) + b"controller".ljust(24, b"\0") +
          b"\1" + order(b"walk", 200) + wait(19) + bytes([0, 0, 5]) + b"\0\2\1\7\0" + wait(9))


def stop_seeds():
    """As stop_datagrams.cpp takes its actions apart."""
    def ask(client, kind):
        return bytes([client, 2, kind])

    def exchange(client, answers=1):
        return bytes([client, 6, answers])

    def signed(what, content):
        content = b"GWTS\x01" + bytes([what]) + content
        return bytes([0, 1, len(content)]) + content

    def said(to_client, content):
        return bytes([0, 4 if to_client else 0, len(content)]) + content

    sleep = bytes([0, 5]) + struct.pack("<H", 31_000)
    write("stop_datagrams", "stops", b"".join(ask(client, client) + exchange(client) * 3 for client in range(3)))
    write("stop_datagrams", "lost_and_replayed", ask(0, 0) + exchange(0, 0) * 3 + sleep + exchange(0) * 2 +
          b"".join(bytes([0, 3, which]) for which in range(6)) + ask(0, 2) + exchange(0) * 2)
    write("stop_datagrams", "own_clients", signed(1, struct.pack("<QI16x", 9, 1)) + signed(3, struct.pack("<QQqIB", 9, 1, 0, 1, 0)) * 2 +
          signed(3, struct.pack("<QQqIB", 9, 1, 0, 3, 1)) + signed(3, struct.pack("<QQqIB", 9, 1, 0, 2, 1)) +
          signed(3, struct.pack("<QQqIB", 9, 2, 0, 4, 2)) + signed(4, struct.pack("<QIBB", 9, 1, 0, 1)))
    write("stop_datagrams", "strangers", ask(1, 1) + said(False, b"GWTS\x01\x03" + bytes(45)) + said(False, b"GWTS\x02\x01" + bytes(44)) +
          said(True, b"GWTS\x01\x04" + struct.pack("<QIBB", 2, 1, 1, 1) + bytes(16)) +
          said(False, b"GWTS\x01\x02" + struct.pack("<QIQq", 2, 1, 1, 5) + bytes(16)) +
          said(False, b"GWTS\x01\x05" + struct.pack("<QQq", 2, 1, 5) + bytes(16)) + exchange(1))


def simulation_seeds():
    """As simulation_requests.cpp takes its actions apart."""
    connect, step = bytes([0, 0]), bytes([0, 3])

    def request(client, link, force, frame=0, duration=0.1, version=None):
        head = b"\x01" if version is None else b"\x00" + struct.pack("<H", version)
        return bytes([client, 5]) + head + b"\x01\x00" + struct.pack("<I48sddddI28x", 7, link, *force, duration, frame)

    def order(client, number, text, kind=b"\x01\x01"):
        return bytes([client, 5]) + b"\x01" + kind + struct.pack("<IH", number, len(text)) + text

    def answer(which, accepted):
        return bytes([0, 4, which, accepted])

    def said(client, content):
        return bytes([client, 1, len(content)]) + content

    write("simulation_requests", "pushes", connect * 2 + b"".join(
        request(client, link, force, frame) + step for client, link, force, frame in
        ((0, b"trunk", (50, 0, 0), 0), (1, b"left_foot", (0, -200, 0), 1), (0, b"head", (0, 0, 0.1), 1))))
    write("simulation_requests", "refused", connect + b"".join(request(0, *wrong) + step for wrong in (
        (b"", (1, 0, 0)), (b"x" * 48, (1, 0, 0)), (b"trunk", (float("nan"), 0, 0)), (b"trunk", (1e300, 0, 0)),
        (b"trunk", (1, 0, 0), 2), (b"trunk", (1, 0, 0), 0, 9.0), (b"trunk", (1, 0, 0), 0, 0.1, 9))) + order(0, 8, b"{}", b"\x00\x07\x00") + step)
    write("simulation_requests", "orders", connect * 2 + b"".join(order(0, 1 + number, text) + step for number, text in enumerate(
        (b"{\"order\": \"seek\", \"time_s\": 1}", b"\x00", b"\x01", b"\x01x", b"\x02", b"", b"{", b"x" * 300))) + order(1, 1, b"{}") + order(1, 1, b"{}") +
          step + answer(1, 1) + bytes([0, 2]) + step + answer(0, 0) + answer(0, 1) + step)
    write("simulation_requests", "strangers", connect * 10 + said(0, b"GWSQ") + said(1, bytes(128)) + said(2, bytes(255)) + step * 2 + bytes([0, 2]))


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    lines, frames = recorded(pathlib.Path(sys.argv[1]))
    bus_seeds(lines, frames)
    mail_seeds()
    block_seeds()
    controller_seeds(frames)
    text_seeds()
    motion_seeds()
    api_seeds()
    conversation_seeds()
    link_seeds()
    stop_seeds()
    simulation_seeds()


if __name__ == "__main__":
    main()
