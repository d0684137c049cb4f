"""The truth: an aircraft flown by JSBSim. No other module imports `jsbsim`; arguments and results are in SI and radians.

A `Plant` is made new for each flight and never reset, because JSBSim's reset keeps failure flags, random generators and more.
Properties are looked up once, when the plant is made; a step reads and writes through their nodes. Signals, frames and signs
are those of `common.signals`.
"""

from __future__ import annotations

import math
import struct
import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from operator import call
from pathlib import Path
from typing import Any

import jsbsim
import numpy as np

from testbed.aircraft.changes import ROTATION, model_folder
from testbed.aircraft.description import Aircraft
from testbed.common.angles import body_from_ned
from testbed.common.cache import Cache
from testbed.common.units import DEGREES_PER_RADIAN, METRES_PER_FOOT
from testbed.inputs.problems import BadInput, Problem, did_you_mean
from testbed.plant.first_load import assure
from testbed.plant.properties import (
    AIR_AND_GROUND,
    AIR_DATA,
    EARTH_DEG_S,
    INTEGRATORS,
    SET_WIND_FPS,
    STATE_PROPERTIES,
    TOTAL_WIND_FPS,
    command_property,
    position_property,
)

_MILSPEC_TURBULENCE = 3

# Runs an iterator to its end and keeps no item: the fastest way to make the calls of a `map`.
_exhaust = deque[bool](maxlen=0).extend


class _Listener(jsbsim.FGLogger):
    """Keeps JSBSim's console silent and remembers what it warned about."""

    def __init__(self) -> None:
        super().__init__()
        self._level = jsbsim.LogLevel.BULK
        self.warnings: list[str] = []

    def set_level(self, level: Any) -> None:
        self._level = level

    def message(self, message: str) -> None:
        if int(self._level) >= int(jsbsim.LogLevel.WARN) and message.strip():
            self.warnings.append(message.strip())


_LASTING = jsbsim.DefaultLogger()
"""JSBSim's own logger. This module holds it, so a thread that drops it frees nothing."""


class _Release:
    """Gives a thread that ends the lasting logger: a listener would be freed after the thread, without the interpreter's lock, and
    abort. What `get_logger` says would not do, because it is the logger set last in any thread."""

    def __del__(self) -> None:
        jsbsim.set_logger(_LASTING)


_of_thread = threading.local()


class NoProperty(BadInput):
    """The JSBSim model has no property of this name: a prefix or an engine's number in the aircraft's YAML is wrong, or
    the model lacks a part of an actuator's block."""


class EngineError(Exception):
    """JSBSim cannot load or start a model; the message is what it says."""


def opened(folder: Path, model: str, physics_hz: float) -> tuple[Any, list[str]]:
    """JSBSim with FOLDER/MODEL.xml loaded, and the list of what it warned about, which grows; raises EngineError.

    It must be known that the model does not end the process, or this process must be one that may end.
    """
    listener = _Listener()
    if threading.current_thread() is not threading.main_thread() and not hasattr(_of_thread, "release"):
        _of_thread.release = _Release()
    jsbsim.set_logger(listener)  # thread-local, so set where the model is loaded
    jsbsim.FGJSBBase().debug_lvl = 0
    fdm = jsbsim.FGFDMExec(str(folder.parent.parent))
    fdm.set_aircraft_path(str(folder))
    fdm.set_dt(1.0 / physics_hz)  # before loading: filters freeze their step when loaded
    with engine_errors():
        done = fdm.load_model(model, False)
    if not done:
        raise EngineError("; ".join(listener.warnings))
    fdm.disable_output()
    return fdm, listener.warnings


@contextmanager
def engine_errors() -> Iterator[None]:
    """Within it, what JSBSim raises is an EngineError."""
    try:
        yield
    except Exception as error:  # JSBSim's own, or whatever its C++ throws
        raise EngineError(str(error)) from None


def loaded(aircraft: Aircraft, physics_hz: float, rotating_air: bool = False) -> Any:
    """JSBSim with the aircraft's model loaded; raises BadInput if it cannot load the model.

    It must be known that the model does not end the process: see `first_load.assure`.
    """
    try:
        with model_folder(aircraft, rotating_air) as folder:
            return opened(folder, aircraft.model, physics_hz)[0]
    except EngineError as error:
        raise _broken_model(aircraft, str(error)) from None


class Plant:
    """One aircraft flown by JSBSim.

    Args:
        aircraft: what to fly.
        physics_hz: rate at which JSBSim integrates [Hz].
        substeps: physics steps in one control step: the control rate is physics_hz / substeps.
        rotating_air: whether the model is to feel the rotation that `blow` gives to the air.

    Raises:
        BadInput: the model's files may not be loaded, or JSBSim cannot load them.
        NoProperty: the model lacks a property that one of the aircraft's actuators needs.

    Attributes:
        blow: sets the velocity of the air over the ground, north, east, down, and its rotation about the body axes, in the units
            of `air_factors`. The model feels the rotation if the plant was made with `rotating_air`.
        step: advances by one control step. With one substep this is JSBSim's own `run`, to save the cost of a call around it.
        raw: [17 + 2 n] the last sample: `signals.STATE`, then the position of each of the n actuators (as if fully
            effective), then the effectiveness of each.
        air_factors: [6] from SI to the units of `blow`.
        factors: [17 + 2 n] from `raw` to SI, but for positions: to degrees and newtons, the units of the aircraft's YAML.
    """

    def __init__(
        self, aircraft: Aircraft, physics_hz: float, substeps: int = 1, rotating_air: bool = False
    ) -> None:
        assure(aircraft)
        self.aircraft = aircraft
        self.physics_hz = physics_hz
        self.dt_s = 1.0 / physics_hz
        self.substeps = substeps
        self._fdm = loaded(aircraft, physics_hz, rotating_air)
        self._manager = self._fdm.get_property_manager()
        self._run = self._fdm.run
        self.step: Callable[[], object] = self._run if substeps == 1 else self._run_substeps
        reads = [*STATE_PROPERTIES, *map(position_property, aircraft.actuators.values())]
        reads += [(f"{a.prefix}/effectiveness", 1.0) for a in aircraft.actuators.values()]
        self._getters = [self.getter(name) for name, _ in reads]
        self.factors = np.array([factor for _, factor in reads])
        self.raw = np.empty(len(reads))
        self._bytes = memoryview(self.raw).cast("B")  # type: ignore[arg-type]
        self._pack = struct.Struct(f"{len(reads)}d").pack_into
        self._commands = [self.setter(command_property(a)) for a in aircraft.actuators.values()]
        self._wind = np.zeros(3)
        self._started = False
        self._put_wind = [self.setter(name) for name in SET_WIND_FPS]
        rotation = [self.setter(name) if self.has(name) else lambda _: False for name in ROTATION]
        self.blow = _together(*self._put_wind, *rotation)
        self.air_factors = np.array([1.0 / METRES_PER_FOOT] * 3 + [1.0] * 3)
        self._total_wind = [self.getter(name) for name in TOTAL_WIND_FPS]

    @contextmanager
    def in_words(self) -> Iterator[None]:
        """Within it, what JSBSim raises while it runs is BadInput, with the model's file."""
        try:
            yield
        except jsbsim.BaseError as error:
            raise _broken_model(self.aircraft, str(error)) from None

    def has(self, name: str) -> bool:
        """Whether the loaded model has a property of this name."""
        return bool(self._manager.hasNode(name))

    def getter(self, name: str) -> Callable[[], float]:
        """Function that reads a property, in JSBSim's unit; raises NoProperty if there is none (JSBSim itself would create it)."""
        return self._node(name).get_double_value

    def setter(self, name: str) -> Callable[[float], bool]:
        """Function that writes a property, in JSBSim's unit; raises NoProperty if there is none."""
        return self._node(name).set_double_value

    def _node(self, name: str) -> Any:
        if not self.has(name):
            close = did_you_mean(name, self.catalog())
            raise NoProperty(
                [Problem(f"has no property {name}", str(self.aircraft.model_file), suggestion=close)]
            )
        return self._manager.get_node(name)

    def catalog(self) -> dict[str, bool]:
        """Name of each property of the loaded model, and whether it can be written."""
        return catalog_of(self._fdm)

    def command(self, commands: Iterable[float]) -> None:
        """Command each actuator: servos in radians, motors as throttle from 0 to 1."""
        _exhaust(map(call, self._commands, commands))

    @property
    def span_m(self) -> float:
        """Wing span [m]; 0 if the model has none."""
        return self["metrics/bw-ft"] * METRES_PER_FOOT

    def _run_substeps(self) -> None:
        for _ in range(self.substeps):
            self._run()

    def sample(self) -> None:
        """Read all signals into `raw`, in JSBSim's units; the loop does this in each step."""
        self._pack(self._bytes, 0, *map(call, self._getters))

    def read(self) -> np.ndarray:
        """The present signals as a new row [17 + 2 n]: `raw` times `factors`."""
        self.sample()
        return self.raw * self.factors

    def position(self, index: int) -> float:
        """Position of one actuator [rad, or N as if fully effective]."""
        value = float(self.read()[len(STATE_PROPERTIES) + index])
        servo = list(self.aircraft.actuators.values())[index].kind == "servo"
        return value / DEGREES_PER_RADIAN if servo else value

    # The air ------------------------------------------------------------------------------------------------

    def set_wind(self, ned_m_s: np.ndarray) -> None:
        """Set the velocity of the air over the ground, without turbulence [m/s, north, east, down]."""
        self._wind = np.array(ned_m_s)
        for put, value in zip(self._put_wind, self._wind, strict=True):
            put(float(value) / METRES_PER_FOOT)

    def set_turbulence(self, w20_m_s: float, severity: int, seed: int | None) -> None:
        """Switch on Dryden turbulence, which builds up from zero; or change its intensity.

        Call it after the last `place`, because JSBSim's run_ic would draw random numbers for it.

        Args:
            w20_m_s: wind at 20 ft (MIL-F-8785C), which sets the intensity up to 1000 ft above sea level.
            severity: JSBSim's index of probability of exceedance, which sets the intensity above 2000 ft.
            seed: 2 or more (to JSBSim 0 and 1 are the same seed); None to go on with its random numbers.
        """
        self["atmosphere/turbulence/milspec/windspeed_at_20ft_AGL-fps"] = w20_m_s / METRES_PER_FOOT
        self["atmosphere/turbulence/milspec/severity"] = severity
        self["atmosphere/turb-type"] = _MILSPEC_TURBULENCE
        if seed is not None:
            self["atmosphere/randomseed"] = seed

    def total_wind(self) -> tuple[float, float, float]:
        """Velocity of the air over the ground in the last step, with turbulence [m/s, north, east, down]."""
        north, east, down = self._total_wind
        return north() * METRES_PER_FOOT, east() * METRES_PER_FOOT, down() * METRES_PER_FOOT

    def air_data(self) -> tuple[float, float, float, float, float, float]:
        """Present airspeed [m/s], alpha, beta, roll, pitch and heading [rad]."""
        airspeed, alpha, beta, roll, pitch, heading = (self[name] * factor for name, factor in AIR_DATA)
        return airspeed, alpha, beta, roll, pitch, heading

    def specific_force_reader(self, axis: str) -> Callable[[], float]:
        """Function that gives the specific force along a body axis: what an accelerometer at the centre of gravity reads [m/s2].

        It is the sum of all forces except gravity, divided by the mass, in the present state. JSBSim's own `a-pilot` is one
        physics step late.
        """
        force, mass = self.getter(f"forces/fb{axis}-total-lbs"), self.getter("inertia/mass-slugs")
        return lambda: METRES_PER_FOOT * force() / mass()

    def air_and_ground_reader(self) -> Callable[[], tuple[float, ...]]:
        """Function that gives the present specific force along the body axes [m/s2], velocity over the ground, north and east
        [m/s], static pressure [Pa] and temperature of the air [K]."""
        forces = [self.specific_force_reader(axis) for axis in "xyz"]
        rest = [(self.getter(name), factor) for name, factor in AIR_AND_GROUND]
        return lambda: (*(force() for force in forces), *(get() * factor for get, factor in rest))

    # Trim and identification: the plant as a test stand -----------------------------------------------------------

    def place(self, state: Mapping[str, float], turning_s: float = 0.0) -> None:
        """Put the airframe into a state; servos, rotors and engines keep their positions and speeds, but a turboprop falls to idle.

        The first time, engines are started as the aircraft's `start` says.

        Args:
            state: airspeed, altitude, alpha and pitch; beta, roll, heading, p, q, r where they are not zero [m/s, m, rad,
                rad/s]. Airspeed, alpha and beta are relative to the air (see `set_wind`).
            turning_s: the place is so far east that the Earth turns to longitude zero in this time [s], in which the airframe
                is held (see `settle`).
        """
        self._place(state, turning_s)
        if not self._started:
            self._started = True
            for step in self.aircraft.start:
                for name, value in step.set.items():
                    self[name] = value
                self.settle(round(step.run_s * self.physics_hz))
            if self.aircraft.start:
                self._place(state, turning_s)

    def _place(self, state: Mapping[str, float], turning_s: float) -> None:
        fdm, get = self._fdm, state.get
        speed, alpha, beta = state["airspeed"] / METRES_PER_FOOT, state["alpha"], get("beta", 0.0)
        # JSBSim's initial velocity is relative to the ground, so the wind's velocity is added.
        attitude = get("roll", 0.0), state["pitch"], get("heading", 0.0)
        u, v, w = map(float, body_from_ned(*attitude) @ self._wind / METRES_PER_FOOT)
        # The order matters to JSBSim: position, then attitude, then velocity.
        fdm["ic/lat-geod-deg"] = 0.0
        fdm["ic/long-gc-deg"] = EARTH_DEG_S * turning_s
        fdm["ic/h-sl-ft"] = state["altitude"] / METRES_PER_FOOT
        fdm["ic/psi-true-rad"] = get("heading", 0.0)
        fdm["ic/phi-rad"] = get("roll", 0.0)
        fdm["ic/theta-rad"] = state["pitch"]
        fdm["ic/u-fps"] = speed * math.cos(alpha) * math.cos(beta) + u
        fdm["ic/v-fps"] = speed * math.sin(beta) + v
        fdm["ic/w-fps"] = speed * math.sin(alpha) * math.cos(beta) + w
        for name in "pqr":
            fdm[f"ic/{name}-rad_sec"] = get(name, 0.0)
        if not fdm.run_ic():
            raise RuntimeError("JSBSim refused the initial condition")

    def settle(self, steps: int) -> None:
        """Run servos, motors and rotors for this many physics steps while the airframe does not move."""
        schemes = [self._fdm[name] for name in INTEGRATORS]
        for name in INTEGRATORS:
            self._fdm[name] = 0
        for _ in range(steps):
            self._run()
        for name, scheme in zip(INTEGRATORS, schemes, strict=True):
            self._fdm[name] = scheme

    def __getitem__(self, name: str) -> float:
        return self.getter(name)()

    def __setitem__(self, name: str, value: float) -> None:
        self.setter(name)(value)


def _together(*setters: Callable[[float], bool]) -> Callable[[Iterable[float]], None]:
    """One function for the six setters of the air: unrolled, it takes two thirds of the time of a loop."""
    put_north, put_east, put_down, put_p, put_q, put_r = setters

    def put(values: Iterable[float]) -> None:
        north, east, down, p, q, r = values
        put_north(north)
        put_east(east)
        put_down(down)
        put_p(p)
        put_q(q)
        put_r(r)

    return put


_catalogs: Cache[dict[str, bool]] = Cache(8)


def catalog_of(fdm: Any) -> dict[str, bool]:
    """Name of each property of a model that `loaded` gave, and whether it can be written."""
    rows = tuple(fdm.get_property_catalog())  # such as `fcs/left-servo (RW)`
    split = (row.rpartition(" (") for row in rows)
    return _catalogs.get(rows, lambda: {name.strip(): "W" in access for name, _, access in split})


def _broken_model(aircraft: Aircraft, why: str) -> BadInput:
    return BadInput([Problem(f"JSBSim says {why}", str(aircraft.model_file))])
