"""Monte Carlo sweeps: many flights drawn from one scenario, and what their results say together.

A sweep file is read by `load`, as `model` allows, into a `plan`, which says what run i is: a pure function of (sweep,
seed, i). `checks` refuses bad ones, `run` flies a plan with `progress` and `stopping`, and `summary` evaluates the
table of results with `statistics` and `sensitivity`. The packages: `drawing` draws values and makes scenarios of them,
`workers` are the processes that fly, `folder` is what is kept of each flight, and how it is read back.
"""

from __future__ import annotations


def is_sweep(tree: object) -> bool:
    """Whether the tree of a YAML file is a sweep's: only a sweep has one of these keys."""
    return isinstance(tree, dict) and any(key in tree for key in ("vary", "cases", "scenario"))
