"""Monte Carlo sweeps: many flights drawn from one scenario, and what they say together.

Run i is a pure function of (sweep, seed, i). `plan` draws it, `flying` flies it in a process of its own,
`store` keeps what came of it, `results` writes the table, `summary` and `figures` read that table.
"""

from __future__ import annotations


def is_sweep(tree: object) -> bool:
    """Whether a YAML file's tree is a sweep: only these name a scenario."""
    return isinstance(tree, dict) and any(key in tree for key in ("vary", "cases", "scenario"))
