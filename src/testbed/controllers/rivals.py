"""Who flies a benchmark: the rivals of the default law, each as its authors would fly it, and those that are told the truth.

Every one has the axes that are derived from the aircraft. `fixed_inversion` is flown with all of them too, as its authors would: a
v-tail cannot keep roll in gusts, and there that holds less. `benchmarks/tune_rivals.py` shows both.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

RIVALS: Mapping[str, Mapping[str, Any]] = {
    "adaptive_inversion": {"type": "adaptive_inversion"},
    "fixed_inversion": {"type": "fixed_inversion"},
    "fixed_inversion_all_axes": {"type": "fixed_inversion", "released": []},
    "pid": {"type": "pid"},
    "indi": {"type": "indi"},
    "indi_monitor": {"type": "indi", "monitor": True},
    "adaptive_indi": {"type": "adaptive_indi"},
    "mrac": {"type": "mrac"},
    "l1_inversion": {"type": "l1_inversion"},
    "rls_inversion": {"type": "rls_inversion", "forgetting_s": 1.0, "lambda_min": 0.3},
    "imm_inversion": {"type": "imm_inversion"},
}
"""`controller` blocks by name, the default law first."""
INFORMED: Mapping[str, Mapping[str, Any]] = {
    "informed_inversion": {"type": "informed_inversion"},
    "informed_patient": {"type": "informed_inversion", "patience_s": 3.0},
    "informed_increments": {"type": "informed_inversion", "increments": True},
    "informed_keeping": {"type": "informed_inversion", "keeps_axes": True},
    "informed_keeping_increments": {"type": "informed_inversion", "keeps_axes": True, "increments": True},
}
"""`controller` blocks that are told the truth. The best of these and of `RIVALS` in a flight says what could be held in it."""
