"""The paper's section 4.3, predicted and measured: writes docs/results/section4_input_matrix.md.

    python benchmarks/section4_input_matrix.py            # 10 000 random plants and some 400 flights, minutes on one core
    python benchmarks/section4_input_matrix.py --quick    # 100 plants and 2 sign patterns, printed and not written

Mathematics and proofs: docs/explanation/input_matrix_error.md.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from aside import aside_in
from input_matrix_plants import PHASES, Found, draw, fly_one, study
from linear_loop import LinearLoop, Slipstream
from paper.matrix_classes import is_p_matrix
from prediction_errors import summary

from testbed.aircraft.changes import ChangedAircraft, load_with_changes
from testbed.common.signals import RATES
from testbed.controllers.setup import Setup
from testbed.flight.flight import Outcome
from testbed.inputs.problems import BadInput
from testbed.inputs.yaml_source import parse
from testbed.margins.bounds import bias_bound, certified_range, error_bound, mismatch, uniform_limit
from testbed.margins.matrix_classes import diagonal_stability, jacobi_radius, normalised
from testbed.plant.identification import input_matrix
from testbed.plant.jsbsim import Plant
from testbed.plant.thrust_stand import stand_physics_hz
from testbed.plant.trim import Trim, trim
from testbed.scenario.load import Scenario, scenario_from
from testbed.simulation import fly, start_and_setup

PAGE = Path(__file__).parents[1] / "docs" / "results" / "section4_input_matrix.md"
ASIDE = {"inside": "## How far the v-tail's matrix lies inside", "bias": "## Bias of the estimates in flight"}
"""Sections whose table stands beside the page."""
BASE = """\
name: section 4.3
aircraft: vtail
duration_s: 90
initial: {altitude_m: 300, airspeed_m_s: 18, heading_deg: 90}
controller: {type: adaptive_inversion, preset: paper, ablate: [monitor]}
commands:
  - {at_s: 2, altitude_m: 300.1, heading_deg: 90.2}
"""
AIRSPEED_M_S, ALTITUDE_M = 18.0, 300.0
LARGER = [{"at_s": 2, "altitude_m": 301, "heading_deg": 92}]
"""Ten times the commands of BASE."""
WORST_OF = 300
"""Sign patterns among which the worst is looked for."""
FIXED = {"type": "fixed_inversion", "released": []}
DEFAULT = {"type": "adaptive_inversion"}
PAPER = {"type": "adaptive_inversion", "preset": "paper", "ablate": ["monitor"]}
LAWS: Mapping[str, tuple[bool, Mapping[str, Any]]] = {
    "limit, fixed": (False, FIXED),
    "limit, adaptive": (True, PAPER),
}
"""Whether it adapts, and its controller: what the linear loop predicts."""
MOST = 0.6
"""Largest error that is flown, nearly twice the certified limit. An error with which the law refuses the model is not settled."""
SETTLED_S, SETTLED, STILL_DEG_S = 20.0, 0.05, 1e-3
"""A flight settles if the largest rate of its last 20 s is less than in the 20 s before, and less than 5 % of that of its first
20 s; or less than 0.001 deg/s, five times what remains of any flight."""


def scenario(**settings: Any) -> Scenario:
    """BASE with other values at its top level."""
    source = parse(BASE, "section 4.3")
    source.tree.update(settings)
    return scenario_from(source)


# Random plants -------------------------------------------------------------------------------------------------


def plants(count: int) -> Iterable[str]:
    inside = study(count)
    outside = [fly_outside(i) for i in range(count // 10)]
    head = (
        "plants",
        "number",
        "not finite",
        "beyond the comparison system",
        "left their bound",
        "not at equilibrium",
    )
    rows = [plants_row("inside", inside), plants_row("r outside the sector: some must fail", outside)]
    yield table((*head, "lam_hat / lam"), rows)


def fly_outside(i: int) -> Found:
    """A plant with a first reference 30 times smaller than certified: a negative control."""
    rng = np.random.default_rng([2, i])
    return fly_one(draw(rng), rng, outside=1.0 / 30.0)


def plants_row(name: str, found: Sequence[Found]) -> tuple[str, ...]:
    return (
        name,
        str(len(found)),
        str(sum(not each.finite for each in found)),
        str(sum(each.overshoot > 1.0 + 1e-9 for each in found)),
        str(sum(each.left for each in found)),
        str(sum(each.off > 1e-4 for each in found)),
        f"{min(each.bias[0] for each in found):.2f} to {max(each.bias[1] for each in found):.3g}",
    )


# How far inside, and what moves it -----------------------------------------------------------------------------


class Truth:
    """The v-tail, or one with changes, on a test stand."""

    def __init__(self, setup: Setup, **changes: Any) -> None:
        self._b = np.array(setup.model.input_matrix)[:4] * setup.scale
        self._scale = setup.scale
        aircraft = load_with_changes(ChangedAircraft(name="vtail", **changes))
        self.plant = Plant(aircraft, stand_physics_hz(aircraft))

    def level(self, airspeed: float = AIRSPEED_M_S) -> Trim:
        return trim(self.plant, airspeed, ALTITUDE_M)

    def m(self, at: Trim) -> np.ndarray:
        """M about a condition, which need not be a trim."""
        return mismatch(self._b, input_matrix(self.plant, at)[:4] * self._scale)


def held(at: Trim, thrust: float = 1.0, **state: float) -> Trim:
    """A trim with other values of its state, and throttles that are multiplied: the airframe is held so."""
    commands = (*at.commands[:2], *(thrust * command for command in at.commands[2:]))
    return Trim({**at.state, **state}, commands, at.positions, at.residual)


def mismatches(setup: Setup) -> Iterable[tuple[str, np.ndarray]]:
    """What is changed, and M with it."""
    truth = Truth(setup)
    at = truth.level()
    for airspeed in (12.6, 14.4, 21.6):
        yield f"level flight at {airspeed} m/s", truth.m(truth.level(airspeed))
    yield "airspeed 21.6 m/s, angle of attack and throttle held", truth.m(held(at, airspeed=21.6))
    yield "angle of attack + 4 deg", truth.m(held(at, alpha=at.state["alpha"] + np.radians(4.0)))
    yield "sideslip 8 deg", truth.m(held(at, beta=np.radians(8.0)))
    yield "throttles + 30 % (advance ratio and slipstream)", truth.m(held(at, 1.3))
    truth.plant["fcs/slipstream-active"] = 0.0
    yield "no slipstream", truth.m(at)
    yield "no slipstream, throttles + 30 % (advance ratio)", truth.m(held(at, 1.3))
    for name, changes in {
        "centre of gravity 20 mm aft": {"cg_shift_x_m": 0.02},
        "centre of gravity 20 mm to the right": {"cg_shift_y_m": 0.02},
        "centre of gravity 20 mm up": {"cg_shift_z_m": 0.02},
        "mass and inertia + 20 %": {"mass_kg": 6.0},
        "Cn of both ruddervators + 20 %": {"coefficients": {"Cn_left": 1.2, "Cn_right": 1.2}},
        "Cm of the left ruddervator + 20 %": {"coefficients": {"Cm_left": 1.2}},
    }.items():
        changed = Truth(setup, **changes)
        yield name, changed.m(changed.level())
    b = np.array(setup.model.input_matrix)[:4] * setup.scale
    for i, name in enumerate(("roll", "pitch", "yaw")):
        scale = np.where(np.arange(4) == i, 1.0 / 1.2, 1.0)
        yield f"moment of inertia in {name} + 20 %", mismatch(b, scale[:, None] * b)


def inside(setup: Setup) -> Iterable[str]:
    found = [(name, m, float(jacobi_radius(m))) for name, m in mismatches(setup)]
    rows = [
        (
            name,
            " ".join(f"{x:.2f}" for x in np.diag(m)),
            f"{100 * np.abs(normalised(m) - np.eye(4)).max():.1f} %",
            f"{radius:.3f}",
            f"{diagonal_stability(m)[0]:.3f}",
        )
        for name, m, radius in found
    ]
    yield table(("changed", "effectiveness", "largest coupling", "H+ radius", "LMI margin"), rows)
    most = sorted(found, key=lambda each: -each[2])[:5]
    yield f"\nIt is moved most by: {'; '.join(f'{name} ({radius:.3f})' for name, _, radius in most)}."


def first_failures(setup: Setup) -> tuple[float, float]:
    """Least uniform error [1], in steps of 1 %, with which a vertex of the box is not H+, and with which one is no P-matrix."""
    b = np.array(setup.model.input_matrix)[:4] * setup.scale
    signs = np.stack(np.meshgrid(*[[-1.0, 1.0]] * 16, indexing="ij"), axis=-1).reshape(-1, 4, 4)
    not_h = 0.0
    for error in np.arange(0.3, 1.0, 0.01):
        m = mismatch(b, b * (1.0 + error * signs))
        bad = jacobi_radius(m) >= 1.0
        not_h = not_h or (float(error) if bad.any() else 0.0)
        if not all(is_p_matrix(each) for each in m[bad]):
            return not_h, float(error)
    raise ValueError("every vertex is a P-matrix up to an error of 100 %")


# Bias in flight ------------------------------------------------------------------------------------------------

BIASES: Mapping[str, Mapping[str, float]] = {
    "Cm left + 20 %": {"Cm_left": 1.2},
    "Cn left + 30 %": {"Cn_left": 1.3},
    "Cl left - 30 %": {"Cl_left": 0.7},
    "Cn left + 30 %, right - 20 %": {"Cn_left": 1.3, "Cn_right": 0.8},
    "Cl, Cm, Cn of both, 10 % with mixed signs": {
        "Cl_left": 1.1, "Cm_left": 0.9, "Cn_left": 1.1, "Cl_right": 0.9, "Cm_right": 1.1, "Cn_right": 1.1,
    },
}  # fmt: skip


def bias(setup: Setup) -> Iterable[str]:
    rows: list[tuple[str, ...]] = []
    for name, coefficients in BIASES.items():
        truth = Truth(setup, coefficients=dict(coefficients))
        by_matrix, by_both, beta = predicted_bias(setup, truth)
        flown = flown_bias(coefficients)
        low, high = certified_range(beta)
        for i, actuator in enumerate(setup.model.actuators):
            certified = f"{low[i]:.3f} to {high[i]:.3f}" if beta[i] < 1.0 else "none"
            rows.append(
                (
                    name if i == 0 else "",
                    actuator,
                    certified,
                    f"{by_matrix[i]:.4f}",
                    f"{by_both[i]:.4f}",
                    f"{flown[i]:.4f}",
                    f"{100 * (flown[i] / by_both[i] - 1):+.2f} %",
                )
            )
    head = (
        "truth changed",
        "actuator",
        "certified by 4.3",
        "predicted by 4.3",
        "by 4.2 and 4.3",
        "flown",
        "relative error",
    )
    yield table(head, rows)


def predicted_bias(setup: Setup, truth: Truth) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """[4] lam_hat in level flight of a changed truth, from its trim: by the error of the input matrix alone (40), and by that of
    the state function too (36); and the bound of the first."""
    at, model = truth.level(), setup.model
    unit = np.where([kind == "servo" for kind in model.kinds], np.radians(1.0), 1.0)
    a = np.array(at.positions) * unit / setup.scale
    m = truth.m(at)
    b, offsets = np.array(model.input_matrix)[:4] * setup.scale, np.array(model.offset_matrix)[:4]
    state = {"p": 0.0, "q": 0.0, "r": 0.0, **at.state}
    left_over = -model.rates(state, np.zeros(4), np.zeros(4))[:4]  # x_c_dot = 0
    both = np.linalg.solve(b * a + offsets, left_over)
    alone = m @ a / a
    e = error_bound(b, np.abs(b @ m - b))
    return alone, both, bias_bound(e, m @ a)


def flown_bias(coefficients: Mapping[str, float]) -> np.ndarray:
    """[4] mean estimate of the last 5 s of level flight."""
    flight = fly(
        scenario(
            aircraft={"name": "vtail", "coefficients": dict(coefficients)},
            controller={**PAPER, "lambda_min": 0.05, "lambda_max": 5.0},
            duration_s=60,
            commands=[],
        )
    )
    names = [f"{actuator}_effectiveness_estimate" for actuator in flight.actuators]
    return np.asarray(flight.log[names].to_numpy()[-1000:].mean(axis=0))


# The outer loop ------------------------------------------------------------------------------------------------


def outer_loop(setup: Setup, patterns: int) -> Iterable[str]:
    loop, rows = LinearLoop(setup, slipstream(setup)), []
    signs = np.random.default_rng(1).choice([-1.0, 1.0], (WORST_OF, 16))

    def stable(pattern: np.ndarray, adapts: bool, exact_state: bool = False) -> float:
        return limit(
            lambda x: loop.growth(errors(setup, x * pattern), adapts=adapts, exact_state=exact_state) < 0.0
        )

    def settling(pattern: np.ndarray, controller: Mapping[str, Any], **settings: Any) -> float:
        return limit(lambda x: settles(errors(setup, x * pattern), controller, **settings))

    worst = min(range(len(signs)), key=lambda i: stable(signs[i], True))
    compared: dict[str, list[tuple[float, float]]] = {name: [] for name in LAWS}
    for number in (*range(patterns), worst):
        pattern, cells = (
            signs[number],
            [f"{number}, the worst of {WORST_OF}" if number == worst else str(number)],
        )
        for name, (adapts, controller) in LAWS.items():
            predicted, flown = stable(pattern, adapts), settling(pattern, controller)
            cells += [size(predicted), size(flown), relative(predicted, flown)]
            if MOST not in (predicted, flown):
                compared[name].append((predicted, flown))
        larger = [size(settling(pattern, controller, commands=LARGER)) for controller in (PAPER, DEFAULT)]
        rows.append((*cells, *larger, size(stable(pattern, False, exact_state=True))))
    three = ("predicted", "flown", "relative error")
    head = ("signs", *(f"fixed, {x}" for x in three), *(f"adaptive, {x}" for x in three))
    larger_head = ("adaptive, larger step", "default law, larger step")
    yield table((*head, *larger_head, "f subtracted exactly"), rows)
    yield "\nA relative error is that of the flown limit over the predicted one. In short:\n"
    yield from summary(compared)


def slipstream(setup: Setup) -> Slipstream:
    """Of the v-tail in level flight: what its propellers do to the tail, found by taking the slipstream away."""
    truth = Truth(setup)
    at = truth.level()
    found, corner = input_matrix(truth.plant, at), truth.plant["fcs/left-slipstream/lag-rad_sec"]
    truth.plant["fcs/slipstream-active"] = 0.0
    servo = np.array([kind == "servo" for kind in setup.model.kinds])
    return Slipstream(np.where(servo, 0.0, found - input_matrix(truth.plant, at)), float(corner))


def errors(setup: Setup, sizes: np.ndarray) -> dict[str, float]:
    """Factors 1 + size on each entry of the input matrix, row by row."""
    symbols = ("Cl", "Cm", "Cn", "CX")  # of the rates p q r u
    assert len(symbols) == len(RATES)
    names = [f"{symbol}_{actuator}" for symbol in symbols for actuator in setup.model.actuators]
    return dict(zip(names, (1.0 + sizes).tolist(), strict=True))


def limit(holds: Callable[[float], bool]) -> float:
    """The error up to which this holds, to 0.25 %; MOST if it holds there."""
    if holds(MOST):
        return MOST
    low, high = 0.0, MOST
    while high - low > 0.0025:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low


def settles(factors: Mapping[str, float], controller: Mapping[str, Any], **settings: Any) -> bool:
    """Whether a flight comes to rest after its steps of altitude and heading."""
    try:
        flight = fly(scenario(controller={**controller, "model_error": dict(factors)}, **settings))
    except BadInput:  # the wrong matrix is too badly conditioned to be flown
        return False
    if flight.outcome is not Outcome.completed:
        return False
    rates = np.abs(flight.log[["p_deg_s", "q_deg_s", "r_deg_s"]].to_numpy()).max(axis=1)
    rows = int(SETTLED_S * len(rates) / flight.end_time_s)
    first, before, last = rates[:rows].max(), rates[-2 * rows : -rows].max(), rates[-rows:].max()
    return bool(last < STILL_DEG_S or last < min(before, SETTLED * first))


def size(error: float) -> str:
    return f"{100 * error:.1f} %" if error < MOST else f">{100 * MOST:.0f} %"


def relative(predicted: float, flown: float) -> str:
    return "" if MOST in (predicted, flown) or not flown else f"{100 * (flown / predicted - 1):+.0f} %"


# The page ------------------------------------------------------------------------------------------------------


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def page(count: int, patterns: int) -> str:
    _, setup = start_and_setup(scenario())
    b = np.array(setup.model.input_matrix)[:4] * setup.scale
    not_h, not_p = first_failures(setup)
    parts = {
        "count": f"{count}",
        "jumps": str(PHASES - 1),
        "plants": "\n".join(plants(count)),
        "limit": f"{100 * uniform_limit(b):.1f} %",
        "not_h": f"{100 * not_h:.0f} %",
        "not_p": f"{100 * not_p:.0f} %",
        "inside": "\n".join(inside(setup)),
        "bias": "\n".join(bias(setup)),
        "most": f"{100 * MOST:.0f} %",
        "outer": "\n".join(outer_loop(setup, patterns)),
    }
    return TEXT.format(**parts)


TEXT = """\
# Error of the input matrix, predicted and measured

<!-- Written by python benchmarks/section4_input_matrix.py: change that, not this. -->

This page measures what [Error of the input matrix](../explanation/input_matrix_error.md) proves about the paper's section 4.3:
on random plants, on the v-tail's own matrix, and in flight.
An error is relative to each entry of the input matrix, of all entries at once.

## Random plants inside the certificate

{count} random plants with four actuators fly the law (13) without limits on the estimates. The matrix, the size of its error and
the sector of the references are random; $B_c$ is at a corner of the error's box, or inside. The references jump every half
second within their sector, and the effectiveness jumps {jumps} times. Then both stay, and the estimates must converge to
$\\hat\\lambda^*$ within 0.01 %. An estimate that has entered its bound must never leave it while the effectiveness is constant.

{plants}

## How far the v-tail's matrix lies inside

The certified limit is {limit}. At the corners of the error's box, the first matrix that is not H+ appears at {not_h}, and the first
that is no P-matrix at {not_p}. Below, the truth is identified again in other conditions, and compared with the design model.
An effectiveness other than 1 is a column's scale, and does no harm. An H+ radius of 1 would be the end of the certificate.

{inside}

## Bias of the estimates in flight

The truth is changed and the controller is not told (`aircraft.coefficients`). In level flight at 18 m/s the estimates settle at
a bias. It is predicted before the flight, from the trim of the changed truth. The slipstream's load on the tail scales with the
same coefficients, so the state function is wrong too: the paper's 4.2 adds to 4.3. The relative error is that of both together.

{bias}

## What the outer loop takes away

Now the design model is wrong, in all 16 entries by the same size with random signs (`controller.model_error`).
The largest size with which the v-tail comes to rest after a step of 0.1 m and 0.2 deg is predicted by the eigenvalues of the
linear closed loop (`benchmarks/linear_loop.py`), and found in flight by bisection. *Fixed* is `fixed_inversion` with no axis
released; *adaptive* is the preset `paper` without its monitor; the *default law* is flown as it is, with roll given up from the
start. The larger step is ten times as large. Errors above {most} were not flown; one with which a law refuses the model counts as
not settled. The linear loop knows the aircraft as the design model does, with the delay of the slipstream and of sampling.

{outer}

The outer loop, not the estimates, decides. $f_m$ is subtracted through the wrong matrix, so the stability derivatives of one axis
act on the others. In the last column the linear loop subtracts $f_m$ exactly, and only the desired rates pass through the wrong
matrix: then it is stable at all sizes tried, nearly to the certified limit. Where both have a limit, adaptation widens that of
the fixed inversion. With larger steps the references leave the sector in which the estimates are bounded, and most limits fall.
"""


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--quick", action="store_true", help="few plants and flights; the page is printed")
    if options.parse_args().quick:
        print(page(100, 2))
    else:
        text = page(10_000, 12)
        for name, heading in ASIDE.items():
            text = aside_in(text, heading, PAGE.with_name(f"{PAGE.stem}_{name}.csv"))
        PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
