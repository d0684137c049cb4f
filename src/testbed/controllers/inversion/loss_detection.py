"""Loss detection: the paper's monitor (section 2.3), which flags an actuator whose effectiveness is low, and what the default law
asks beyond that.

Letters: those of `records`.
"""
# mypy: allow-untyped-defs

from __future__ import annotations

from testbed.common.jit import compiled
from testbed.controllers.inversion.evidence import BEYOND_DOUBT, HALF_WAY, SLOW_S
from testbed.controllers.inversion.law import TIMER_ROUNDING
from testbed.controllers.inversion.offset_detection import deviation, goes_against


@compiled
def is_to_blame(i, c, s):
    """Whether a low estimate of actuator i is its own failure, and not the effect of another's.

    It is if the estimate fell by more than `HALF_WAY`, or if no other estimate in use has changed by more and none of those is at
    its upper limit.

    When another actuator fails, all estimates share the explanation of its force at first. One at its upper limit shows a force
    that no effectiveness explains. The estimate of an actuator that is weak already has little way to go to the threshold: a
    surface with 0.1 to 0.25 was given up when a propeller stuck."""
    fell = s.lambda_slow[i] - s.lambda_hat[i]
    if fell > HALF_WAY or not c.weighted:
        return True
    for j in range(len(s.lambda_hat)):
        if j != i and not s.failed[j]:
            changed = abs(s.lambda_slow[j] - s.lambda_hat[j]) > fell
            if changed or s.lambda_hat[j] >= c.lambda_max:
                return False
    return True


@compiled
def works(i, c, s):
    """Whether a flagged actuator has effect enough to be used again: its estimate is above `recovery`, or above `threshold` beyond
    doubt."""
    least = c.threshold + c.threshold_rise[i] + BEYOND_DOUBT * deviation(i, s)
    return s.lambda_hat[i] > c.recovery or (c.weighted and s.lambda_hat[i] > least)


@compiled
def monitor(m, c, s):
    """Section 2.3: flag an actuator as failed when its estimate stays below `threshold`, and remove the flag when it
    `works` for the `recovery_time`. Returns 1 if a flag changed.

    An actuator is flagged only if its estimate's standard deviation is at most `flag_std_max`. The estimate of an actuator that
    hardly moves is uncertain, so a low value is no evidence of failure. (13) gives no standard deviation: with it the limit is
    infinite. With `weighted`, `is_to_blame` must also hold.

    `ModeSwitch` takes a flag back as `early` if altitude cannot be held without the actuator. It is set again when the estimate has
    stayed low for `SLOW_S`.
    """
    changed = 0
    for i in range(len(s.lambda_hat)):
        if s.jammed[i]:
            continue  # its estimate is a position; `jam_detection` has its timers
        s.lambda_slow[i] += c.dt / SLOW_S * (s.lambda_hat[i] - s.lambda_slow[i])
        if s.failed[i]:
            beyond, time = works(i, c, s), c.recovery_time
        else:
            certain = s.P[i, i] <= c.flag_std_max * c.flag_std_max
            low = s.lambda_hat[i] < c.threshold + c.threshold_rise[i]  # section 2.3: below a threshold
            against = c.tests_jams and goes_against(i, m, s)  # not lost: held or reversed (`jam_detection`)
            beyond = low and certain and not against and (s.early[i] or is_to_blame(i, c, s))
            time = SLOW_S if s.early[i] else c.persistence
        s.flag_timer[i] = s.flag_timer[i] + c.dt if beyond else 0.0
        s.since_flag[i] += c.dt
        if s.flag_timer[i] > time + TIMER_ROUNDING:
            s.early[i] = 1 if c.weighted and not s.failed[i] and not s.early[i] else 0
            s.failed[i] = 0 if s.failed[i] else 1
            s.flag_timer[i], s.since_flag[i] = 0.0, 0.0
            changed = 1
    return changed
