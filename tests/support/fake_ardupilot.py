#!/usr/bin/env python3
"""A fake ArduPilot, written from its JSON interface: no line of the real one. It flies by a few gains of its own.

FAKE_FAULT of the environment is what it does wrong, from its packet FAKE_AT on.
"""

import json
import math
import os
import re
import signal
import socket
import struct
import sys
import time

FAULT, AT = os.environ.get("FAKE_FAULT", ""), int(os.environ.get("FAKE_AT", "4050"))
given = dict(zip(sys.argv[1::2], sys.argv[2::2], strict=False))
with open(given["--defaults"]) as file:
    lines = [line.split() for line in file]
parameters = {name: float(value) for name, value in lines}
channels = {int(parameters.get(f"SERVO{n}_FUNCTION", 0)): n for n in range(16, 0, -1)}
print("fake autopilot", given["--home"], flush=True)

states = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
states.connect(("127.0.0.1", int(given["--sim-port-out"])))
link = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
_, host, port = given["--serial0"].split(":")
link.connect((host, int(port)))
link.send(b"heartbeat")
link.setblocking(False)
ending = []
signal.signal(signal.SIGTERM, lambda *_: None if FAULT == "goes on" else ending.append(1))

count, armed, guided, target, heard = 0, False, False, {}, []
pulses = [0] * 16
begun = time.monotonic()


def say_parameters(name):
    """Send the value of a parameter, or of all; of one that it does not have nothing, as the real one."""
    from pymavlink.dialects.v20 import common

    known = re.compile(r"(?!PTHC).*(?<!_RATE_PX)")
    has = [each for each in parameters if known.fullmatch(each)]
    for each in has if not name else {name} & {*has}:
        value = common.MAVLink_param_value_message(each.encode(), parameters[each], 9, len(has), 65535)
        link.send(value.pack(common.MAVLink(None)))


def listen():
    """Take the MAVLink commands that have come."""
    global armed, guided
    while True:
        try:
            frame = link.recv(300)
        except BlockingIOError:
            return
        payload = frame[10:-2].ljust(35, b"\0")
        if frame[7] in (20, 21):
            say_parameters(payload[4:20].rstrip(b"\0").decode() if frame[7] == 20 else "")
            continue
        if frame[7] == 76:
            _, second, *_, command = struct.unpack("<7fH", payload[:30])
            armed, guided = (
                armed or (command, second) == (400, 21196),
                guided or (command, second) == (176, 15),
            )
        else:
            numbers, altitude, command = (
                struct.unpack("<4f", payload[:16]),
                *struct.unpack("<fH", payload[24:30]),
            )
            target[command] = altitude if command == 43001 else numbers[1]
        heard.append((count, command))


def fly(state):
    """Pulse widths: climb and bank by proportional gains, through the servo functions of the parameters."""
    roll, pitch, heading = state["attitude"]
    p, q, r = state["imu"]["gyro"]
    climb = max(-3.0, min(3.0, 0.5 * (target.get(43001, 0.0) + state["position"][2])))
    nose = math.radians(parameters["PTCH_TRIM_DEG"]) + climb / 18.0 - pitch
    error = (math.radians(target.get(43002, 0.0)) - heading + math.pi) % (2.0 * math.pi) - math.pi
    bank = max(-0.4, min(0.4, error)) - roll
    up, right = 0.8 * nose - 0.15 * q, 0.25 * bank - 0.1 * p - 0.1 * r
    throttle = (
        parameters["TRIM_THROTTLE"] / 100.0
        + 0.1 * (target.get(43000, 18.0) - state["airspeed"])
        + 0.15 * climb
    )
    demands = {19: up, 21: right, 4: 0.5 * bank - 0.1 * p, 79: up + right, 80: up - right}
    for function, n in channels.items():
        low, high, trim = (parameters.get(f"SERVO{n}_{name}", 1500.0) for name in ("MIN", "MAX", "TRIM"))
        if function in (70, 73, 74):
            pulses[n - 1] = (
                round(low + max(0.0, min(1.0, throttle)) * (high - low)) if armed and guided else 0
            )
        elif function in demands:
            pulses[n - 1] = round(max(low, min(high, trim + 500.0 * demands[function])))


def packet():
    """The packet of this count, or what the fault makes of it."""
    if FAULT == "long":
        return struct.pack("<HHI32H", 29569, 200, count, *pulses, *[0] * 16)
    whole = struct.pack("<HHI16H", 18458, 200, count, *pulses)
    if count < AT:
        return whole
    jumped = struct.pack("<HHI16H", 18458, 200, count + 5, *pulses)
    wrong = {
        "magic": b"\x01\x02" + whole[2:],
        "rubbish": b"\xff" * 1000,
        "short": whole[:39],
        "jumps": jumped,
    }
    return wrong.get(FAULT, whole)


def misbehave():
    """What a fault does instead of an answer."""
    if FAULT == "slow":
        time.sleep(0.01)
    if count == AT and FAULT == "stalls":
        time.sleep(600)
    if count == AT and FAULT == "dies":
        sys.exit("no fuel")
    if count == AT and FAULT == "killed":
        os.kill(os.getpid(), signal.SIGSEGV)


while not ending:
    misbehave()
    for _ in range(3 if FAULT == "repeats" else 1):
        states.send(packet())
    answer = states.recv(65536)
    assert answer[:1] == answer[-1:] == b"\n" and b": " not in answer
    state = json.loads(answer)
    # the wall clock runs until the first state, and what waits by it would take other steps in each flight
    assert count or state["timestamp"] > time.monotonic() - begun
    listen()
    fly(state)
    count += 1
if FAULT == "goes on":
    time.sleep(600)
os.makedirs("logs", exist_ok=True)
with open("logs/00000001.BIN", "w") as log:
    json.dump([count, heard], log)
