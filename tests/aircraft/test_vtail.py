"""The v-tail in JSBSim itself: worth controlling, controllable when broken, and what its README says it is.

Everything is measured on the loaded model, by trim and central differences; the design model is compared with that.
What is printed is shown by `pytest tests/aircraft/test_vtail.py -s`.
"""

from __future__ import annotations

import importlib.util
import math
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import pytest
from scipy.linalg import expm

from testbed.aircraft.description import Aircraft
from testbed.aircraft.design_model import COLUMNS, DESIGN_MODEL, ROWS, DesignModel, load_design_model
from testbed.aircraft.shipped import data_root
from testbed.common.angles import wrap
from testbed.common.signals import STATE
from testbed.common.units import METRES_PER_FOOT, NEWTON_METRES_PER_FOOT_POUND, NEWTONS_PER_POUND
from testbed.controllers.inversion.degraded_aircraft import motion
from testbed.controllers.inversion.steady_flights import jacobian
from testbed.controllers.records import REGULATOR_STATE
from testbed.plant.jsbsim import Plant
from testbed.plant.trim import Trim, accelerations, trim

HZ = 200
LEFT_TAIL, RIGHT_TAIL, LEFT_PROPELLER, RIGHT_PROPELLER = range(4)
REACH = 0.72  # share of a tail panel in its propeller's slipstream at the trim's alpha
STEPS = np.array([0.05, 0.05, 0.05, 0.005, 0.005, 0.005, 0.005, 0.005])  # m/s, rad/s, rad
P, Q, R = 3, 4, 5  # rows of `accelerations` and of a body state


@dataclass(frozen=True)
class Body:
    """Linear motion about the trim, measured in JSBSim: states u, v, w, p, q, r, roll, pitch."""

    trim: Trim
    A: np.ndarray
    B: np.ndarray
    """[6, 4] accelerations u, v, w, p, q, r per rad of tail and per N of thrust, rotors steady."""


def condition_of(x: np.ndarray) -> dict[str, float]:
    """State for `Plant.place` of u, v, w, p, q, r, roll, pitch; heading east (see `test_mirror_symmetry`)."""
    u, v, w, p, q, r, roll, pitch = map(float, x)
    speed = math.sqrt(u * u + v * v + w * w)
    angles = {"alpha": math.atan2(w, u), "beta": math.asin(v / speed), "roll": roll, "pitch": pitch}
    return {"airspeed": speed, "altitude": 300.0, "heading": math.pi / 2, "p": p, "q": q, "r": r, **angles}


def body_state(state: Mapping[str, float]) -> np.ndarray:
    """u, v, w, p, q, r, roll, pitch of a trimmed state."""
    speed, alpha, beta = state["airspeed"], state["alpha"], state["beta"]
    u, v = speed * math.cos(alpha) * math.cos(beta), speed * math.sin(beta)
    w = speed * math.sin(alpha) * math.cos(beta)
    return np.array([u, v, w, 0.0, 0.0, 0.0, state["roll"], state["pitch"]])


@pytest.fixture(scope="module")
def stored_model(vtail: Aircraft) -> DesignModel:
    return load_design_model(vtail.folder / DESIGN_MODEL)


@pytest.fixture(scope="module")
def body(vtail: Aircraft) -> Body:
    plant = Plant(vtail, HZ)
    level = trim(plant, 18.0, 300.0)
    x0 = body_state(level.state)

    def motion(x: np.ndarray) -> np.ndarray:
        p, q, r, roll, pitch = x[3:]
        turn = q * math.sin(roll) + r * math.cos(roll)
        angles = [p + math.tan(pitch) * turn, q * math.cos(roll) - r * math.sin(roll)]
        return np.append(accelerations(plant, condition_of(x), level.commands), angles)

    a = [(motion(x0 + h) - motion(x0 - h)) / (2.0 * h.max()) for h in np.diag(STEPS)]
    return Body(
        level, np.column_stack(a), np.column_stack([_per_actuator(plant, level, i) for i in range(4)])
    )


def _per_actuator(plant: Plant, level: Trim, i: int) -> np.ndarray:
    ends = []
    for sign in (1.0, -1.0):
        command = np.array(level.commands)
        command[i] += sign * 0.004
        ends.append((accelerations(plant, level.state, command), plant.position(i)))
    return (ends[0][0] - ends[1][0]) / (ends[0][1] - ends[1][1])


# Modes ------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Modes:
    short_period: complex
    phugoid: complex
    dutch_roll: complex
    roll: float
    spiral: float


def modes_of(matrix: np.ndarray) -> Modes:
    """Name the eigenvalues of a motion matrix; raises where they are not three pairs and two real ones."""
    roots = [z for z in np.linalg.eigvals(matrix) if abs(z) > 1e-3]  # heading and altitude are integrals
    pairs = sorted((z for z in roots if z.imag > 1e-3), key=abs)
    spiral, roll = sorted((float(z.real) for z in roots if abs(z.imag) <= 1e-3), key=abs)
    phugoid, dutch_roll, short_period = pairs
    return Modes(complex(short_period), complex(phugoid), complex(dutch_roll), roll, spiral)


def damping(z: complex) -> float:
    return -z.real / abs(z)


def test_modes_are_plausible(body: Body) -> None:
    """Damping and times: level 1 of MIL-F-8785C, class I, category A (flying qualities of piloted airplanes, 1980):
    short period 0.35 to 1.30 (3.2.2.1.2), phugoid above 0.04 (3.2.1.2), Dutch roll zeta > 0.19, zeta w > 0.35 rad/s,
    w > 1 rad/s (3.3.1.1), roll below 1.0 s (3.3.1.2), spiral doubling in more than 12 s (3.3.1.3).

    Frequencies of a small UAV are higher than those limits foresee, as 1/sqrt(length). Their range is half to twice
    what the Aerosonde's parameters give (Beard and McLain, Small Unmanned Aircraft, 2012, appendix E): short period
    11.1, Dutch roll 5.1 rad/s. The phugoid's is near Lanchester's sqrt(2) g / V = 0.77 rad/s.
    """
    m = modes_of(body.A)
    for name, z in (("short period", m.short_period), ("phugoid", m.phugoid), ("Dutch roll", m.dutch_roll)):
        print(f"{name}: {abs(z):.3f} rad/s, damping {damping(z):.3f}")
    print(f"roll: {-1.0 / m.roll:.4f} s; spiral: doubles in {math.log(2.0) / m.spiral:.2f} s")
    assert 0.35 < damping(m.short_period) < 1.30
    assert 11.1 / 2 < abs(m.short_period) < 11.1 * 2
    assert 0.04 < damping(m.phugoid) < 0.5
    assert 0.5 < abs(m.phugoid) / (math.sqrt(2.0) * 9.81 / 18.0) < 1.5
    assert damping(m.dutch_roll) > 0.19
    assert -m.dutch_roll.real > 0.35
    assert 5.1 / 2 < abs(m.dutch_roll) < 5.1 * 2
    assert 0.0 < -1.0 / m.roll < 1.0
    assert m.spiral < math.log(2.0) / 12.0


def test_modes_are_what_the_aircraft_does(vtail: Aircraft, body: Body) -> None:
    """Let go from a disturbed state, JSBSim flies what the linear motion says: x(t) = exp(A t) x(0).

    Within 2 % of the largest value of each state: the rotors' lag, left out of A, and what is not linear. Flown at
    2000 Hz, because at 200 Hz JSBSim's integration alone takes 7 % off the fast pitch rate.
    """
    start = body_state(body.trim.state)
    disturbance = np.array([0.1, 0.05, 0.1, 0.02, 0.02, 0.02, 0.01, 0.01])
    substeps = 10
    plant = Plant(vtail, substeps * HZ, substeps)
    plant.command(body.trim.commands)
    plant.place(condition_of(start + disturbance))
    plant.settle(300 * substeps)
    plant.place(condition_of(start + disturbance))
    flown, linear = [], []
    for step in range(1, 2 * HZ + 1):
        plant.step()
        y = dict(zip(STATE, plant.read(), strict=False))
        airspeed, alpha, beta = y["airspeed"], y["alpha"], y["beta"]
        w = airspeed * math.sin(alpha) * math.cos(beta)
        u = airspeed * math.cos(alpha) * math.cos(beta)
        rest = [y["p"], y["q"], y["r"], wrap(y["roll"]), y["pitch"]]
        flown.append(np.array([u, airspeed * math.sin(beta), w, *rest]) - start)
        linear.append(expm(body.A * step / HZ) @ disturbance)
    error = np.max(np.abs(np.array(flown) - linear), axis=0) / np.max(np.abs(linear), axis=0)
    print("largest difference from the linear motion, % of each state:", np.round(100 * error, 2))
    assert np.all(error < 0.02), error


def _as_the_design_model_has_it(vtail: Aircraft, body: Body) -> np.ndarray:
    """The motion matrix less two effects of forward speed that f_m leaves out: a propeller's loss of thrust, and the pitching
    moment of the rate of alpha that follows from more lift."""
    plant, x0 = Plant(vtail, HZ), body_state(body.trim.state)
    thrusts, moments, rates = [], [], []
    for change in (STEPS[0], -STEPS[0]):
        accelerations(plant, condition_of(x0 + change * np.eye(8)[0]), body.trim.commands)
        thrusts.append(np.array([plant.position(LEFT_PROPELLER), plant.position(RIGHT_PROPELLER)]))
        moments.append(plant["aero/coefficient/Cm_alphadot"] / plant["inertia/iyy-slugs_ft2"])
        rates.append(plant["aero/alphadot-rad_sec"])
    matrix, (u, _, w) = body.A.copy(), x0[:3]
    by_alpha_rate = (moments[0] - moments[1]) / (rates[0] - rates[1])
    alpha_rate = (u * matrix[2, 0] - w * matrix[0, 0]) / (u * u + w * w)
    matrix[Q, 0] -= by_alpha_rate * alpha_rate
    matrix[:6, 0] -= body.B[:, LEFT_PROPELLER:] @ ((thrusts[0] - thrusts[1]) / (2 * STEPS[0]))
    return matrix


def test_design_model_has_the_aircrafts_modes(vtail: Aircraft, body: Body, stored_model: DesignModel) -> None:
    """The controller's f_m against JSBSim: the same modes within 0.1 %, the phugoid within 2 %.

    Two effects of forward speed that the design model leaves out move the phugoid by 7 % each, in opposite directions, and
    damp it. It is compared with JSBSim's motion without them.
    """
    x = np.array([body.trim.state.get(name, 0.0) for name in REGULATOR_STATE])
    A = jacobian(lambda z: motion(stored_model, z, np.array(stored_model.trim), np.ones(4)), x)
    truth, model = modes_of(body.A), modes_of(A)
    same = modes_of(_as_the_design_model_has_it(vtail, body))
    assert model.short_period == pytest.approx(truth.short_period, rel=1e-3)
    assert model.dutch_roll == pytest.approx(truth.dutch_roll, rel=1e-3)
    assert model.roll == pytest.approx(truth.roll, rel=1e-3)
    assert model.spiral == pytest.approx(truth.spiral, rel=1e-2)
    assert model.phugoid == pytest.approx(same.phugoid, rel=2e-2)
    assert damping(model.phugoid) < damping(truth.phugoid)


def test_static_stability(body: Body) -> None:
    """Nose comes back in pitch and yaw, dihedral rolls out of a sideslip, every rate is damped."""
    speed = 18.0
    q_alpha, p_beta, r_beta = body.A[Q, 2] * speed, body.A[P, 1] * speed, body.A[R, 1] * speed
    print(f"q_dot/alpha {q_alpha:.1f}, p_dot/beta {p_beta:.1f}, r_dot/beta {r_beta:.1f} 1/s2")
    assert q_alpha < 0.0
    assert p_beta < 0.0
    assert r_beta > 0.0
    assert all(body.A[row, row] < 0.0 for row in range(6)), "u, v, w, p, q, r each damped"


# Controllability --------------------------------------------------------------------------------------------------


def test_the_input_matrix_is_well_conditioned(body: Body, stored_model: DesignModel) -> None:
    """B_m of (2) with columns scaled by 0.2 rad and 2 N: 25 is asked."""
    b = body.B[[P, Q, R, 0]]
    scaled = float(np.linalg.cond(b * [0.2, 0.2, 2.0, 2.0]))
    print(f"condition number of the input matrix: {np.linalg.cond(b):.1f}, scaled {scaled:.2f}")
    assert scaled < 25.0
    np.testing.assert_allclose(np.array(stored_model.input_matrix)[:4], b, rtol=2e-3, atol=2e-4)


def test_the_sign_that_decides_which_axis_can_be_released(body: Body) -> None:
    """D = n_d |l_b| - n_b l_d > 0: with a propeller lost, r_dot by the tails is minimum phase and p_dot is not."""
    n_d = abs(body.B[R, LEFT_TAIL] - body.B[R, RIGHT_TAIL])
    l_d = abs(body.B[P, LEFT_TAIL] - body.B[P, RIGHT_TAIL])
    n_b, l_b = body.A[R, 1] * 18.0, body.A[P, 1] * 18.0
    d = n_d * abs(l_b) - n_b * l_d
    print(f"D = {d:.0f} 1/s4 (n_d {n_d:.1f}, l_d {l_d:.1f}, n_b {n_b:.1f}, l_b {l_b:.1f})")
    assert d > 500.0, "well away from zero, where a lost propeller has no trim at all"


@pytest.fixture(scope="module")
def broken_trims(vtail: Aircraft, body: Body) -> dict[int, Trim]:
    """Level flight at 18 m/s in JSBSim after each single loss, the lost actuator held at its healthy command."""
    trims = {}
    for lost, actuator in enumerate(vtail.actuators.values()):
        plant = Plant(vtail, HZ)
        plant[f"{actuator.prefix}/effectiveness"] = 0.0
        held = {lost: body.trim.commands[lost]}
        trims[lost] = trim(plant, 18.0, 300.0, held=held, free=("alpha", "beta", "roll"))
    return trims


def test_every_single_failure_has_a_trim_with_room(vtail: Aircraft, broken_trims: dict[int, Trim]) -> None:
    """Level at the reference speed, sideslip inside the linear range, what is left 30 % away from its stops."""
    for lost, found in broken_trims.items():
        beta, roll = (math.degrees(found.state[name]) for name in ("beta", "roll"))
        print(f"{list(vtail.actuators)[lost]} lost: beta {beta:.2f} deg, roll {roll:.2f}, "
              f"positions {np.round(found.positions, 2)}")  # fmt: skip
        assert found.residual < 1e-6
        assert abs(beta) < 8.0
        for i, actuator in enumerate(vtail.actuators.values()):
            low, high = actuator.limits
            if i != lost and actuator.kind == "servo":
                assert abs(found.positions[i]) < 0.7 * high
            elif i != lost:
                assert low < found.positions[i] < low + 0.7 * (high - low)


@pytest.mark.parametrize("lost", [LEFT_TAIL, RIGHT_TAIL])
def test_both_propellers_pull_after_a_tail_loss(broken_trims: dict[int, Trim], lost: int) -> None:
    """At least a third of their mean each: an aircraft that needs one idle limit-cycles."""
    thrusts = broken_trims[lost].positions[LEFT_PROPELLER:]
    share = min(thrusts) / (sum(thrusts) / 2.0)
    print(f"least thrust over mean: {share:.3f}")
    assert share > 1.0 / 3.0


def test_one_motor_has_thrust_to_spare(vtail: Aircraft, body: Body) -> None:
    """2.3 times the total drag, also within the limit that the controller is given."""
    plant = Plant(vtail, HZ)
    accelerations(plant, body.trim.state, [*body.trim.commands[:2], 1.0, body.trim.commands[3]])
    drag = sum(body.trim.positions[LEFT_PROPELLER:])
    print(f"full throttle over drag: {plant.position(LEFT_PROPELLER) / drag:.2f}")
    assert plant.position(LEFT_PROPELLER) > 2.3 * drag
    assert list(vtail.actuators.values())[LEFT_PROPELLER].limits[1] > 2.3 * drag


# The model --------------------------------------------------------------------------------------------------------


def test_mirror_symmetry(vtail: Aircraft) -> None:
    """A mirrored state with mirrored commands accelerates as the mirror image, over the whole envelope.

    Heading east on the equator, where the Earth's rotation is its own mirror image too. Not to the bit: left and right
    are summed in the same order on both sides, so each acceleration may differ in its last digits.
    """
    random = np.random.default_rng(1)
    signs = np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])
    for _ in range(10):
        speed, alpha, beta = random.uniform(12, 25), random.uniform(-0.1, 0.3), random.uniform(-0.3, 0.3)
        x = np.array([speed, 0, 0, *random.normal(size=3), *random.uniform(-0.5, 0.5, 2)])
        state = condition_of(x) | {"alpha": alpha, "beta": beta}
        command = np.append(random.uniform(-0.4, 0.4, 2), random.uniform(0.3, 1.0, 2))
        mirrored = {n: -v if n in ("beta", "p", "r", "roll") else v for n, v in state.items()}
        here = accelerations(Plant(vtail, HZ), state, command)
        there = signs * accelerations(Plant(vtail, HZ), mirrored, command[[1, 0, 3, 2]])
        np.testing.assert_allclose(there, here, rtol=1e-10, atol=1e-10)


AERO = [f"forces/fb{axis}-aero-lbs" for axis in "xyz"] + [f"moments/{axis}-aero-lbsft" for axis in "lmn"]
ENGINES = [name.replace("aero", "prop") for name in AERO]
LOSSES = [name.replace("aero", "external") for name in AERO]  # what the model takes off a broken propeller


def _loads(plant: Plant, names: list[str]) -> np.ndarray:
    """[6] forces [N] and moments [N m] on the airframe now."""
    units = [NEWTONS_PER_POUND] * 3 + [NEWTON_METRES_PER_FOOT_POUND] * 3
    return np.array([plant[name] for name in names]) * units


@pytest.mark.parametrize("side", ["left", "right"])
def test_effectiveness_of_a_tail_scales_its_force(vtail: Aircraft, body: Body, side: str) -> None:
    """After the servo, in the same step, and in full proportion: lift, side force and all three moments.

    Drag is left out: a part of it goes with the square of the effective deflection.
    """
    plant = Plant(vtail, HZ)
    plant["fcs/slipstream-active"] = 0.0
    commands = list(body.trim.commands)
    commands[side == "right"] = 0.1
    accelerations(plant, body.trim.state, commands)
    name = f"fcs/{side}-ruddervator/effectiveness"
    loads = {}
    for value in (1.0, 0.5, 0.0):
        plant[name] = value
        plant.settle(1)  # one step, the airframe held still
        loads[value] = _loads(plant, AERO)
    healthy = loads[1.0] - loads[0.0]
    half = loads[0.5] - loads[0.0]
    rows = [1, 2, 3, 4, 5]
    assert np.all(np.abs(healthy[rows]) > 0.01), "each of them is a load that can be scaled"
    np.testing.assert_allclose(half[rows], 0.5 * healthy[rows], rtol=2e-2)
    assert plant.position(side == "right") == pytest.approx(0.1, abs=1e-6), "the servo itself is healthy"
    qbar_s = plant["aero/qbar-psf"] * plant["metrics/Sw-sqft"] * NEWTONS_PER_POUND
    assert -healthy[2] == pytest.approx(0.1446 * 0.1 * qbar_s, rel=0.01), "CL of the README"


@pytest.mark.parametrize("side", ["left", "right"])
def test_effectiveness_of_a_propeller_scales_thrust_and_torque_together(
    vtail: Aircraft, body: Body, side: str
) -> None:
    """In the same step; the thrust at its own arm of 0.30 m, the torque against the propeller's sense.

    Exactly: the loads of both propellers are read apart from air loads and weight.
    """
    plant = Plant(vtail, HZ)
    accelerations(plant, body.trim.state, body.trim.commands)
    engine, sense = (0, -1.0) if side == "left" else (1, 1.0)
    thrust = plant.position(LEFT_PROPELLER + engine)
    torque = abs(plant[f"propulsion/engine[{engine}]/propeller-torque-ftlb"]) * NEWTON_METRES_PER_FOOT_POUND
    loads = {}
    for value in (1.0, 0.5, 0.0):
        plant[f"fcs/{side}-propeller/effectiveness"] = value
        plant.settle(1)
        loads[value] = _loads(plant, ENGINES) + _loads(plant, LOSSES)
    healthy = loads[1.0] - loads[0.0]
    print(f"{side} propeller: {thrust:.3f} N, {torque:.4f} N m")
    assert healthy[0] == pytest.approx(thrust, rel=1e-6)
    assert healthy[3] == pytest.approx(-sense * torque, rel=1e-6)
    assert healthy[5] == pytest.approx(-sense * 0.30 * thrust, rel=1e-3)
    np.testing.assert_allclose(loads[0.5] - loads[0.0], 0.5 * healthy, rtol=1e-6, atol=1e-9)


def test_a_slipstream_is_that_of_momentum_theory(vtail: Aircraft, body: Body) -> None:
    """(1 + w)^2 = 1 + T / (qbar A) of what is left of each propeller's thrust, at the tail one lag later."""
    plant = Plant(vtail, HZ)
    accelerations(plant, body.trim.state, body.trim.commands)
    steady = plant["fcs/left-slipstream/excess"]
    disc_m2, qbar_pa = (
        0.25 * math.pi * 0.4826**2,
        plant["aero/qbar-psf"] * NEWTONS_PER_POUND / METRES_PER_FOOT**2,
    )
    assert (1 + steady) ** 2 == pytest.approx(
        1 + body.trim.positions[LEFT_PROPELLER] / (qbar_pa * disc_m2), rel=1e-4
    )
    plant["fcs/left-propeller/effectiveness"] = 0.0
    lag_s = 1.045 / 18.0
    plant.settle(round(lag_s * HZ))
    assert plant["fcs/left-slipstream/excess"] == pytest.approx(steady * math.exp(-1.0), rel=0.1)
    plant.settle(HZ)
    assert abs(plant["fcs/left-slipstream/excess"]) < 1e-6
    assert plant["fcs/right-slipstream/excess"] == pytest.approx(steady, rel=1e-3)


def test_a_tail_feels_its_own_propeller_alone(vtail: Aircraft, body: Body) -> None:
    """More thrust on the left makes the left ruddervator stronger by its share of the pressure, the right one not at all."""
    lift = {}
    for throttle in (body.trim.commands[LEFT_PROPELLER], 1.0):
        for command in (0.1, -0.1):
            for tail in (LEFT_TAIL, RIGHT_TAIL):
                plant = Plant(vtail, HZ)
                commands = [*body.trim.commands[:2], throttle, body.trim.commands[RIGHT_PROPELLER]]
                commands[tail] = command
                accelerations(plant, body.trim.state, commands)
                lift[throttle, command, tail] = -plant["forces/fbz-aero-lbs"]
        w = plant["fcs/left-slipstream/excess"]
        lift[throttle] = (1 + w) ** 2 - 1
    trimmed = body.trim.commands[LEFT_PROPELLER]
    power = {
        (throttle, tail): lift[throttle, 0.1, tail] - lift[throttle, -0.1, tail]
        for throttle in (trimmed, 1.0)
        for tail in (LEFT_TAIL, RIGHT_TAIL)
    }
    assert power[1.0, RIGHT_TAIL] == pytest.approx(power[trimmed, RIGHT_TAIL], rel=1e-6)
    share = (power[1.0, LEFT_TAIL] / power[trimmed, RIGHT_TAIL] * (1 + REACH * lift[trimmed]) - 1) / lift[1.0]
    assert share == pytest.approx(REACH, rel=0.01)


# The design model and where the numbers come from -----------------------------------------------------------------


def test_the_design_model_is_mirror_symmetric(stored_model: DesignModel) -> None:
    """Left and right columns are each other's mirror image, and no side derivative leaks into the symmetric rows."""
    signs = np.array([-1.0 if row in ("p_dot", "r_dot", "v_dot") else 1.0 for row in ROWS])
    inputs, slopes = np.array(stored_model.input_matrix), np.array(stored_model.derivatives)
    for left, right in ((0, 1), (2, 3)):
        np.testing.assert_allclose(inputs[:, right], signs * inputs[:, left], atol=1e-6)
    for j, column in enumerate(COLUMNS):
        lateral = column in ("beta", "p", "r")
        for i, sign in enumerate(signs):
            if lateral != (sign < 0):
                assert abs(slopes[i, j]) < 2e-3, (ROWS[i], column)


@pytest.mark.skipif(
    any(importlib.util.find_spec(name) is None for name in ("aerosandbox", "optvl")),
    reason="coefficients are rederived and compared only with AeroSandbox and AVL (pip install 'testbed[derive]')",
)
@pytest.mark.parametrize("script", ["derive.py", "avl.py"])
def test_the_coefficients_can_be_rederived_and_are_those_of_avl(script: str) -> None:
    script = data_root() / "aircraft" / "vtail" / script
    result = subprocess.run(
        [sys.executable, str(script), "--check"], capture_output=True, text=True, check=False
    )
    assert result.returncode == 0, result.stdout + result.stderr


def test_the_airframe_is_the_stated_geometry(vtail: Aircraft) -> None:
    """Without AeroSandbox: what the README states of size and mass is what JSBSim loaded."""
    plant = Plant(vtail, HZ)
    accelerations(
        plant, {"airspeed": 18.0, "alpha": 0.05, "altitude": 300.0, "pitch": 0.05}, [0, 0, 0.5, 0.5]
    )
    assert plant["metrics/Sw-sqft"] * METRES_PER_FOOT**2 == pytest.approx(0.55, rel=1e-3)
    assert plant["metrics/bw-ft"] * METRES_PER_FOOT == pytest.approx(2.0, rel=1e-6)
    assert plant["inertia/mass-slugs"] * 14.5939 == pytest.approx(5.0, rel=1e-3)
    mine = {name for name in plant.catalog() if name.startswith("fcs/") and name.endswith("/effectiveness")}
    assert mine == {f"{actuator.prefix}/effectiveness" for actuator in vtail.actuators.values()}


def test_what_a_replay_shows_is_that_of_the_geometry() -> None:
    script = data_root() / "aircraft" / "vtail" / "shape.py"
    assert subprocess.run([sys.executable, str(script), "--check"], check=False).returncode == 0
