"""What a page may ask for is closed: all else is refused in words."""

from __future__ import annotations

import json

import pytest

from testbed.inputs.problems import BadInput
from testbed.live.messages import Break, Rewind, read

REFUSED = {
    "nothing": "",
    "no JSON": "{",
    "a number": "7",
    "no vocabulary": '{"id": 1, "do": "exec", "code": "print()"}',
    "no number": '{"do": "save"}',
    "a key too many": '{"id": 1, "do": "save", "folder": "/etc"}',
    "text for a number": '{"id": 1, "do": "rewind", "time_s": "5"}',
    "no number at all": '{"id": 1, "do": "rewind", "time_s": NaN}',
    "too fast": '{"id": 1, "do": "speed", "times": 17}',
    "neither": '{"id": 1, "do": "pause", "on": 1}',
    "a list": '{"id": 1, "do": "break", "failure": []}',
    "deep": "[" * 2000,
}


@pytest.mark.parametrize("text", REFUSED.values(), ids=REFUSED)
def test_what_is_refused(text: str) -> None:
    with pytest.raises(BadInput) as refused:
        read(text)
    assert str(refused.value).startswith("message")


def test_what_is_read() -> None:
    failure = {"type": "stuck", "actuator": "left_ruddervator"}
    message = read(json.dumps({"id": 3, "do": "break", "failure": failure}))
    assert message == Break(id=3, do="break", failure=failure)
    assert read(b'{"id": 4, "do": "rewind", "time_s": 2}') == Rewind(id=4, do="rewind", time_s=2.0)
