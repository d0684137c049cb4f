"""The MAVLink 2 frames that are exchanged with an autopilot: https://mavlink.io/en/guide/serialization.html, unsigned."""

from __future__ import annotations

import struct
from collections.abc import Iterator

ARM, SET_MODE, PLAIN_SPEED, SET_INTERVAL = 400, 176, 178, 511
"""Commands of COMMAND_LONG: arm (1, 21196 without checks); set the mode (1, the autopilot's own number); the airspeed (0, m/s);
how often a message is sent (its number, us)."""
FORCE = 21196
CHANGE_SPEED, CHANGE_ALTITUDE, CHANGE_HEADING = 43000, 43001, 43002
"""Commands of COMMAND_INT that move the setpoints of guided flight."""
PARAM_VALUE, HIL_ACTUATOR_CONTROLS = 22, 93

_MAGIC, _HEAD, _TAIL = 0xFD, 10, 2
_STATION, _PART = 255, 190  # a ground station
_EXTRA = {0: 50, 20: 214, 21: 159, 22: 220, 75: 158, 76: 152, 84: 143, 93: 47, 107: 108, 113: 124}
"""Of each message's number, the byte of its definition that enters the checksum."""
_TARGET = (1, 1)
_NED, _WITHOUT_ACCELERATION_AND_YAW = 1, 0b1101_1100_0000


def _of_byte(crc: int) -> int:
    for _ in range(8):
        crc = crc >> 1 ^ 0x8408 if crc & 1 else crc >> 1
    return crc


_CRC = [_of_byte(byte) for byte in range(256)]


def command_long(sequence: int, command: int, *parameters: float) -> bytes:
    """The frame of COMMAND_LONG with up to seven parameters."""
    numbers = (*parameters, *[0.0] * (7 - len(parameters)))
    return _frame(sequence, 76, struct.pack("<7fHBBB", *numbers, command, *_TARGET, 0))


def command_int(sequence: int, command: int, *parameters: float, z: float = 0.0) -> bytes:
    """The frame of COMMAND_INT with up to four parameters and an altitude above sea level [m]."""
    numbers = (*parameters, *[0.0] * (4 - len(parameters)))
    return _frame(sequence, 75, struct.pack("<4fiifHBBBBB", *numbers, 0, 0, z, command, *_TARGET, 0, 0, 0))


def heartbeat(sequence: int) -> bytes:
    """The frame of HEARTBEAT, by which an autopilot knows that a ground station is there."""
    return _frame(sequence, 0, struct.pack("<I5B", 0, 6, 8, 0, 4, 3))


def parameter_request(sequence: int, name: str) -> bytes:
    """The frame of PARAM_REQUEST_READ; who does not have the parameter may stay silent."""
    return _frame(sequence, 20, struct.pack("<hBB16s", -1, *_TARGET, name.encode()))


def parameter_list(sequence: int) -> bytes:
    """The frame of PARAM_REQUEST_LIST."""
    return _frame(sequence, 21, struct.pack("<BB", *_TARGET))


def parameter_name(payload: bytes) -> str:
    """Of PARAM_VALUE: the parameter's name."""
    return payload[8:24].rstrip(b"\0").decode("ascii", "replace")


def path_target(sequence: int, *position_and_velocity: float) -> bytes:
    """The frame of SET_POSITION_TARGET_LOCAL_NED: three of a position [m], three of a velocity [m/s]."""
    numbers = (*position_and_velocity, *[0.0] * 5)
    said = struct.pack("<I11fHBBB", 0, *numbers, _WITHOUT_ACCELERATION_AND_YAW, *_TARGET, _NED)
    return _frame(sequence, 84, said)


def hil_sensor(sequence: int, time_us: int, *numbers: float, fields: int) -> bytes:
    """The frame of HIL_SENSOR: force [m/s2], gyro [rad/s], magnetic field [gauss], each on three axes; static and differential
    pressure [hPa], pressure altitude [m], temperature [deg C]; `fields` has a bit for each that is new."""
    return _frame(sequence, 107, struct.pack("<Q13fIB", time_us, *numbers, fields, 0))


def hil_gps(sequence: int, time_us: int, *numbers: int) -> bytes:
    """The frame of HIL_GPS: latitude, longitude [1e-7 deg], altitude [mm]; speed over the ground and velocity [cm/s]."""
    place, speeds = numbers[:3], numbers[3:]
    said = struct.pack("<QiiiHHHhhhHBB", time_us, *place, 50, 50, *speeds, 65535, 3, 12)
    return _frame(sequence, 113, said)


def frames(data: bytes) -> Iterator[tuple[int, bytes, int]]:
    """Number and payload of each whole frame of a stream that begins with one, and where it ends; raises ValueError for rubbish."""
    at = 0
    while len(data) - at >= _HEAD + _TAIL:
        if data[at] != _MAGIC:
            raise ValueError(f"bytes that begin with {data[at : at + 8]!r}")
        payload_ends = at + _HEAD + data[at + 1]
        end = payload_ends + _TAIL + (13 if data[at + 2] & 1 else 0)
        if len(data) < end:
            return
        number = int.from_bytes(data[at + 7 : at + 10], "little")
        checked = data[at + 1 : payload_ends]
        if number in _EXTRA and data[payload_ends : payload_ends + _TAIL] != _sum(number, checked):
            raise ValueError(f"message {number} with a wrong checksum")
        yield number, data[at + _HEAD : payload_ends], (at := end)


def actuator_controls(payload: bytes) -> tuple[int, bool, tuple[float, ...]]:
    """Of HIL_ACTUATOR_CONTROLS: its time [us], whether the autopilot is armed, and the sixteen controls from -1 to 1."""
    time_us, _, *controls, mode = struct.unpack("<QQ16fB", payload.ljust(81, b"\0"))
    return time_us, bool(mode & 128), tuple(controls)


def _frame(sequence: int, number: int, payload: bytes) -> bytes:
    payload = payload.rstrip(b"\0") or b"\0"
    head = struct.pack(
        "<6BHB", len(payload), 0, 0, sequence % 256, _STATION, _PART, number & 0xFFFF, number >> 16
    )
    checked = head + payload
    return bytes([_MAGIC]) + checked + _sum(number, checked)


def _sum(number: int, checked: bytes) -> bytes:
    """CRC-16/MCRF4XX of a frame."""
    crc = 0xFFFF
    for byte in checked + bytes([_EXTRA[number]]):
        crc = crc >> 8 ^ _CRC[(crc ^ byte) & 0xFF]
    return struct.pack("<H", crc)
