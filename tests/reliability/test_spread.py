"""A limit state that several processes, or a cluster, compute gives what one process gives."""

from __future__ import annotations

import dataclasses
from typing import Any

import pytest
from spread_limit_states import ends, linear

from testbed.inputs.problems import BadInput
from testbed.reliability import failure_probability


def fields(**more: Any) -> dict[str, Any]:
    found = failure_probability(linear, 2, method="plain", cov=0.2, budget=3000, **more)
    return {f.name: repr(getattr(found, f.name)) for f in dataclasses.fields(found)}


def test_the_result_does_not_depend_on_who_computes_it() -> None:
    assert fields() == fields(jobs=2)


def test_a_cluster_computes_the_same() -> None:
    distributed = pytest.importorskip("distributed", reason="the cluster extra")
    with distributed.Client(processes=False, dashboard_address=None, set_as_default=False) as client:
        assert fields(client=client) == fields()
        with pytest.raises(BadInput, match="returned arrays of shapes"):
            failure_probability(lambda u: u, 2, method="plain", client=client)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"limit_state": lambda u: u[:, 0], "jobs": 2}, "cannot be sent to another process"),
        ({"jobs": 0}, "jobs: is 0"),
        ({"jobs": 2, "client": object()}, "expected one of them"),
        ({"limit_state": ends, "jobs": 1}, "ended its process"),
    ],
)
def test_what_cannot_be_spread_is_said(given: dict[str, Any], said: str) -> None:
    with pytest.raises(BadInput, match=said):
        failure_probability(**{"limit_state": linear, "dimensions": 2, "method": "plain", **given})
