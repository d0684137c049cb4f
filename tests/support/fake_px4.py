#!/usr/bin/env python3
"""A fake PX4, written from its simulator's interface: no line of the real one. It flies by a few gains of its own.

FAKE_FAULT of the environment is what it does wrong, from its step FAKE_AT on.
"""

import math
import os
import signal
import socket
import sys
import time

from pymavlink.dialects.v20 import common

FAULT, AT = os.environ.get("FAKE_FAULT", ""), int(os.environ.get("FAKE_AT", "6050"))
instance = int(sys.argv[sys.argv.index("-i") + 1])
print("fake px4", sys.argv[sys.argv.index("-d") + 1], os.environ["PX4_SYS_AUTOSTART"], flush=True)
given = {name[10:]: float(value) for name, value in os.environ.items() if name.startswith("PX4_PARAM_")}
if FAULT == "absent":
    time.sleep(600)
simulator = socket.create_connection(("127.0.0.1", 4560 + instance))
link = socket.socket(type=socket.SOCK_DGRAM)
link.bind(("127.0.0.1", 14580 + instance))
link.setblocking(False)
signal.signal(signal.SIGTERM, lambda *_: None if FAULT == "goes on" else sys.exit(end()))
decoder, commands = common.MAVLink(None), common.MAVLink(None)
answers = common.MAVLink(None)
armed, offboard, target, speed, steps, silent = False, False, None, 18.0, 0, 3


def end():
    """Leave a log, as the real one does, in folders of its own."""
    os.makedirs("log/today", exist_ok=True)
    with open("log/today/flight.ulg", "w") as log:
        log.write(f"{steps} {given['CA_ROTOR_COUNT']:g}")


def listen():
    """Take the commands that have come."""
    global armed, offboard, target, speed
    while True:
        try:
            said = commands.parse_buffer(link.recv(300)) or []
        except BlockingIOError:
            return
        for message in said:
            if message.get_msgId() == 84:
                target = message
            elif message.get_msgId() == 76 and (message.command, message.param2) == (400, 21196):
                armed = FAULT != "unarmed"
            elif message.get_msgId() == 76 and (message.command, message.param2) == (176, 6):
                offboard = target is not None
            elif message.get_msgId() == 76 and message.command == 178:
                speed = message.param2


def attitude(sensor):
    """Pitch and roll by a filter of gyro and accelerometer, heading by the magnetic field: nothing else says them."""
    global pitch, roll
    if steps == 0:
        pitch, roll = math.asin(max(-1.0, min(1.0, sensor.xacc / 9.81))), 0.0
    pitch += 0.005 * (sensor.ygyro * math.cos(roll) - sensor.zgyro * math.sin(roll))
    roll += 0.005 * (
        sensor.xgyro + math.tan(pitch) * (sensor.ygyro * math.sin(roll) + sensor.zgyro * math.cos(roll))
    )
    level = sensor.ymag * math.cos(roll) - sensor.zmag * math.sin(roll)
    ahead = sensor.xmag * math.cos(pitch) + math.sin(pitch) * (
        sensor.ymag * math.sin(roll) + sensor.zmag * math.cos(roll)
    )
    return pitch, roll, math.atan2(-level, ahead) + math.radians(3.3)


def controls(sensor):
    """Climb and bank by proportional gains, shared among the surfaces by what the parameters say of them."""
    global first
    nose, bank, heading = attitude(sensor)
    altitude = 44330.77 * (1.0 - (sensor.abs_pressure / 1013.25) ** 0.190263)
    if steps == 0:
        first = altitude
    if not armed or target is None:
        return [0.0] * 16
    course = math.atan2(target.vy, target.vx)
    climb = max(-3.0, min(3.0, 0.5 * (first - target.z - altitude)))
    error = (course - heading + math.pi) % (2.0 * math.pi) - math.pi
    up = 1.5 * (math.radians(given["FW_PSP_OFF"]) + climb / 18.0 - nose) - 0.3 * sensor.ygyro
    right = 0.5 * (max(-0.4, min(0.4, error)) - bank) - 0.2 * sensor.xgyro - 0.2 * sensor.zgyro
    airspeed = math.sqrt(max(200.0 * sensor.diff_pressure, 0.0) / 1.225)
    throttle = given["FW_THR_TRIM"] + 0.1 * (speed - airspeed) + 0.15 * climb
    said, surface = [0.0] * 16, 0
    for n in range(16):
        function = given.get(f"PWM_MAIN_FUNC{n + 1}", 0)
        if 101 <= function < 201:
            said[n] = max(0.0, min(1.0, throttle))
        elif function >= 201:
            share = [given[f"CA_SV_CS{surface}_TRQ_{axis}"] for axis in "PYR"]
            said[n] = given[f"CA_SV_CS{surface}_TRIM"] + up * share[0] + right * share[1]
            surface += 1
    return said


def misbehave():
    """What a fault does instead of an answer."""
    if steps < AT:
        return b""
    if FAULT == "stalls":
        time.sleep(600)
    if FAULT == "dies":
        sys.exit("no fuel")
    if FAULT == "killed":
        os.kill(os.getpid(), signal.SIGSEGV)
    if FAULT == "slow":
        time.sleep(0.01)
    return {"rubbish": b"\xff" * 1000, "megabytes": b"\0" * 5_000_000}.get(FAULT, b"")


while read := simulator.recv(65536):
    for message in decoder.parse_buffer(read) or []:
        if message.get_msgId() != 107:
            continue
        listen()
        said = controls(message)
        steps += 1
        if steps < silent:
            continue  # its modules are still starting
        if extra := misbehave():
            simulator.sendall(extra)
        if FAULT == "nan" and steps > AT:
            said[0] = math.nan
        time_us = message.time_usec - (5000 if FAULT == "late" and steps > AT else 0)
        frame = common.MAVLink_hil_actuator_controls_message(time_us, said, 128 * armed, 1).pack(answers)
        answers.seq = (answers.seq + 1) % 256
        if FAULT == "checksum" and steps > AT:
            frame = frame[:-1] + bytes([frame[-1] ^ 1])
        simulator.sendall(frame * (3 if FAULT == "repeats" else 1))
if FAULT == "goes on":
    time.sleep(600)
end()
