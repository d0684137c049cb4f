"""Exact conversion factors, for input and output, and the units of columns; elsewhere everything is in SI and radians."""

import math

METRES_PER_FOOT = 0.3048
NEWTONS_PER_POUND = 4.4482216152605
NEWTON_METRES_PER_FOOT_POUND = METRES_PER_FOOT * NEWTONS_PER_POUND
DEGREES_PER_RADIAN = 180.0 / math.pi
GRAVITY_M_S2 = 9.80665
METRES_PER_SECOND_PER_KNOT = 1852.0 / 3600.0

_BY_ENDING = {
    "_per_s": "1/s", "_deg_s2": "deg/s^2", "_m_s3": "m/s^3", "_m_s2": "m/s^2", "_deg_s": "deg/s", "_m_s": "m/s", "_deg": "deg",
    "_rad_s": "rad/s", "_rad": "rad", "_hz": "Hz", "_m": "m", "_s": "s", "_n": "N", "_percent": "%",
}  # fmt: skip


_DENSITY = "_rthz"


def unit(column: str) -> str:
    """Unit of a column, from the end of its name; "" when it has none."""
    last = column.rpartition(".")[2].removesuffix(_DENSITY)
    found = next((unit for ending, unit in _BY_ENDING.items() if last.endswith(ending)), "")
    return f"{found}/sqrt(Hz)" if column.endswith(_DENSITY) else found


def worded(name: str) -> str:
    """A name in words, with its unit: `rate_deg_s` is `rate [deg/s]`."""
    plain = name.removesuffix(_DENSITY)
    plain = plain.removesuffix(next((ending for ending in _BY_ENDING if plain.endswith(ending)), ""))
    return f"{plain.replace('_', ' ')} [{unit(name)}]" if unit(name) else plain.replace("_", " ")


def endings(of: str) -> list[str]:
    """The endings of names that stand for a unit."""
    return [ending for ending, unit in _BY_ENDING.items() if unit == of]
