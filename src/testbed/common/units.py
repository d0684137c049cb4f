"""Exact conversion factors, for input and output; elsewhere everything is in SI and radians."""

import math

METRES_PER_FOOT = 0.3048
NEWTONS_PER_POUND = 4.4482216152605
NEWTON_METRES_PER_FOOT_POUND = METRES_PER_FOOT * NEWTONS_PER_POUND
DEGREES_PER_RADIAN = 180.0 / math.pi
GRAVITY_M_S2 = 9.80665
METRES_PER_SECOND_PER_KNOT = 1852.0 / 3600.0
