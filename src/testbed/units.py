"""Exact conversions at the program's borders; inside, everything is SI and radians."""

import math

METRES_PER_FOOT = 0.3048
NEWTONS_PER_POUND = 4.4482216152605
NEWTON_METRES_PER_FOOT_POUND = METRES_PER_FOOT * NEWTONS_PER_POUND
DEGREES_PER_RADIAN = 180.0 / math.pi
GRAVITY_M_S2 = 9.80665
