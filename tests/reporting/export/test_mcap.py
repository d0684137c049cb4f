"""MCAP read back by the reader of the mcap package; the rotation against the project's own frames and scipy's."""

from __future__ import annotations

import json
from collections import defaultdict
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mcap.reader import make_reader
from scipy.spatial.transform import Rotation

from testbed.common.angles import body_from_ned
from testbed.flight.flight import Flight
from testbed.reporting.export import export
from testbed.reporting.export.mcap import rotation

_EPOCH_NS = 946684800 * 10**9


@pytest.fixture
def messages(flown: Flight, tmp_path: Path) -> dict[str, list[tuple[int, str, dict[str, Any]]]]:
    """{topic: (time [ns], schema's name, contents) in order}."""
    found = defaultdict(list)
    with export(flown, "mcap", tmp_path / "flight.mcap").open("rb") as stream:
        for schema, channel, message in make_reader(stream, validate_crcs=True).iter_messages():
            assert (schema.encoding, channel.message_encoding) == ("jsonschema", "json")
            contents = json.loads(message.data)
            assert set(contents) <= set(json.loads(schema.data)["properties"])
            found[channel.topic].append((message.log_time, schema.name, contents))
    return found


def test_topics_have_foxgloves_schemas(flown: Flight, messages: dict[str, list[Any]]) -> None:
    schemas = {topic: said[0][1] for topic, said in messages.items()}
    assert schemas["/tf"] == "foxglove.FrameTransform"
    assert schemas["/location"] == "foxglove.LocationFix"
    assert schemas["/events"] == "foxglove.Log"
    assert {f"/actuators/{name}" for name in flown.actuators} <= set(messages)
    assert {"/state", "/references", "/wind"} <= set(messages)


def test_messages_are_the_log(flown: Flight, messages: dict[str, list[Any]]) -> None:
    log = flown.log.set_index("time_s").loc[2.0]
    at = {
        topic: next(c for time, _, c in said if time == _EPOCH_NS + 2 * 10**9)
        for topic, said in messages.items()
        if topic != "/events"
    }
    assert at["/state"]["timestamp"] == {"sec": 946684802, "nsec": 0}
    assert at["/state"]["airspeed_m_s"] == log["airspeed_m_s"]
    assert at["/actuators/left_ruddervator"]["position"] == log["left_ruddervator_position"]
    assert at["/wind"]["wind_east_m_s"] == log["wind_east_m_s"]
    moved = at["/tf"]["translation"]
    assert (moved["x"], moved["y"], moved["z"]) == (log["east_m"], log["north_m"], log["altitude_m"])
    events = [(c["message"], (time - _EPOCH_NS) / 1e9) for time, _, c in messages["/events"]]
    assert [time for _, time in events] == pytest.approx([event["time_s"] for event in flown.events])
    assert "left ruddervator" in events[0][0]


def test_rotation_is_that_of_the_frames() -> None:
    """Components in x forward, y left, z up, turned to east, north, up: the known frames with two axes the other way."""
    for roll, pitch, heading in [(0, 0, 0), (30, 0, 90), (0, 20, 350), (-50, 40, 200), (170, -80, 10)]:
        (quaternion,) = rotation(np.array([roll]), np.array([pitch]), np.array([heading]))
        to_ned = body_from_ned(*np.radians([roll, pitch, heading])).T
        enu_from_ned = np.array([[0, 1, 0], [1, 0, 0], [0, 0, -1]])
        expected = enu_from_ned @ to_ned @ np.diag([1, -1, -1])
        np.testing.assert_allclose(Rotation.from_quat(quaternion).as_matrix(), expected, atol=1e-12)
