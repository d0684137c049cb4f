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
_DENSITY = "_rthz"  # after the unit: of white noise


def unit(column: str) -> str:
    """Unit of a column, from the end of its name; "" when it has none."""
    return _split(column.rpartition(".")[2])[1]


def worded(name: str) -> str:
    """A name in words, with its unit: `rate_deg_s` is `rate [deg/s]`."""
    plain, unit = _split(name)
    return plain.replace("_", " ") + (f" [{unit}]" if unit else "")


def _split(name: str) -> tuple[str, str]:
    """A name without its ending, and the unit that this stands for."""
    of_all = name.removesuffix(_DENSITY)
    ending = next((each for each in _BY_ENDING if of_all.endswith(each)), "")
    found = _BY_ENDING.get(ending, "")
    return of_all.removesuffix(ending), found if of_all == name else f"{found}/sqrt(Hz)"


def endings(of: str) -> list[str]:
    """The endings of names that stand for a unit."""
    return [ending for ending, unit in _BY_ENDING.items() if unit == of]
