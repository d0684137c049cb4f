"""The MAVLink 2 frames that an autopilot is commanded by: https://mavlink.io/en/guide/serialization.html, unsigned."""

from __future__ import annotations

import struct

ARM, SET_MODE = 400, 176
"""Commands of COMMAND_LONG: arm (1, 21196 without checks); set the mode (1, the autopilot's own number)."""
CHANGE_SPEED, CHANGE_ALTITUDE, CHANGE_HEADING = 43000, 43001, 43002
"""Commands of COMMAND_INT that move the setpoints of guided flight."""

_MAGIC = 0xFD
_STATION, _PART = 255, 190  # a ground station
_LONG, _INT = (
    (76, 152),
    (75, 158),
)  # number of the message, and the byte of its definition that enters the checksum
_TARGET = (1, 1)


def command_long(sequence: int, command: int, *parameters: float) -> bytes:
    """The frame of COMMAND_LONG with up to seven parameters."""
    numbers = (*parameters, *[0.0] * (7 - len(parameters)))
    return _frame(sequence, *_LONG, struct.pack("<7fHBBB", *numbers, command, *_TARGET, 0))


def command_int(sequence: int, command: int, *parameters: float, z: float = 0.0) -> bytes:
    """The frame of COMMAND_INT with up to four parameters and an altitude above sea level [m]."""
    numbers = (*parameters, *[0.0] * (4 - len(parameters)))
    return _frame(sequence, *_INT, struct.pack("<4fiifHBBBBB", *numbers, 0, 0, z, command, *_TARGET, 0, 0, 0))


def _frame(sequence: int, number: int, extra: int, payload: bytes) -> bytes:
    payload = payload.rstrip(b"\0") or b"\0"
    head = struct.pack(
        "<6BHB", len(payload), 0, 0, sequence % 256, _STATION, _PART, number & 0xFFFF, number >> 16
    )
    checked = head + payload
    return bytes([_MAGIC]) + checked + struct.pack("<H", _checksum(checked + bytes([extra])))


def _checksum(data: bytes) -> int:
    """CRC-16/MCRF4XX."""
    crc = 0xFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ 0x8408 if crc & 1 else crc >> 1
    return crc
