"""A controller of one's own: testbed run SCENARIO --controller my_controller.py:MyController"""

import math


class MyController:
    """Loops on pitch, yaw and airspeed, mixed into two ruddervators and two throttles."""

    def __init__(self, setup):
        self.trim, self.dt = setup.trim_commands, setup.dt_s
        self.pitch_0, self.climb = setup.trim_pitch, 0.0

    def update(self, time_s, state, reference):
        error = reference.altitude - state.altitude
        self.climb += 0.02 * error * self.dt
        pitch = self.pitch_0 + (reference.altitude_rate + 0.5 * error + self.climb) / state.airspeed
        elevator = 0.3 * (state.pitch - pitch) + 0.1 * state.q  # positive trailing edge down: nose down

        turn = math.remainder(reference.heading - state.heading, 2 * math.pi)
        bank = max(-0.4, min(0.4, 1.8 * (reference.heading_rate + 0.5 * turn)))
        yaw_rate = 9.8 / state.airspeed * math.sin(state.roll) + 1.0 * (bank - state.roll)
        rudder = 0.3 * (yaw_rate - state.r)  # positive nose right: the left surface up, the right one down
        throttle = 0.1 * (reference.airspeed - state.airspeed)
        mixed = (elevator - rudder, elevator + rudder, throttle, throttle)
        return [trim + command for trim, command in zip(self.trim, mixed, strict=True)]
