"""The numbers of the law that docs/explanation/control.md says are those of the law."""

from __future__ import annotations

import pytest
from command_line import ROOT

from testbed.aircraft.control_design import AllocationWeights
from testbed.controllers import initial_records, released_axes, scaling
from testbed.controllers.config import AdaptiveInversionSettings
from testbed.controllers.inversion import (
    estimator,
    evidence,
    jam_detection,
    mode_trim,
    offset_detection,
    probing,
    sensor_guard,
)

PAGE = " ".join((ROOT / "docs" / "explanation" / "control.md").read_text(encoding="utf-8").split())
SET = AdaptiveInversionSettings.model_validate({"type": "adaptive_inversion"})
NUMBER = {2: "two", 3: "three"}
SENTENCES = [
    f"kept if its authority is at least {released_axes.MARGIN['q_dot']:g} times its disturbance, airspeed if it is at least once",
    f"two first-order lags of {SET.filter_rad_s:g} rad/s",
    f"of the last {estimator.CHANGE_TIME_S:g} s",
    f"If one change is more than {estimator.CHANGE_SIGMA:g} standard deviations, "
    f"and explains it {estimator.CHANGE_LEAD:g} times better",
    f"the standard deviation of its estimate is below {SET.flag_std_max:g}, and the estimate itself below {SET.threshold:g}, "
    f"or {SET.propeller_threshold:g} for a motor or engine, for {SET.persistence_s:g} s",
    f"its estimate has fallen by more than {evidence.HALF_WAY:g} within a few seconds",
    f"when for {SET.recovery_s:g} s its estimate is above {SET.recovery:g} (`recovery`), or "
    f"{NUMBER[evidence.BEYOND_DOUBT]} of its standard deviations above the threshold",
    f"`lambda_min` is {SET.lambda_min:g} here",
    f"until its estimate has stayed below its threshold for {evidence.SLOW_S:g} s",
    f"A miss of `u_dot` weighs {AllocationWeights().u_dot:g} of a miss of an attitude axis",
    f"Altitude is given up with a lag of {initial_records._GIVE_UP_TIME_S:g} s",
    f"the variance that gusts leave of its mean over {evidence.MEAN_S:g} s",
    f"with a force beyond {offset_detection.JAM_SIGMA:g} standard deviations (below)",
    f"in use, and for {evidence.SLOW_S:g} s $b$ holds as much of its thrust",
    f"once it has followed for {evidence.MEAN_S:g} s, with a force beyond {offset_detection.JAM_SIGMA:g} standard deviations",
    f"if its estimate is certain and below {-evidence.HALF_WAY:g} for `persistence_s`",
    f"below that limit is {NUMBER[evidence.BEYOND_DOUBT]} standard deviations below zero "
    f"for {jam_detection.REVERSED_S:g} s",
    f"gives thrust beyond {NUMBER[evidence.BEYOND_DOUBT]} standard deviations for {evidence.MEAN_S:g} s "
    f"at the trim throttle (a probed engine for {jam_detection.ENGINE_S:g} s)",
    f"no effectiveness between {SET.lambda_min:g} and {SET.lambda_max:g} explains",
    f"each is believed when the other is {NUMBER[evidence.BEYOND_DOUBT]} standard deviations away",
    f"goes more than {jam_detection.REVERSAL_SHARE:g} of that way within {estimator.REVERSAL_S:g} s, "
    "and the way is longer than one scaled unit",
    f"a sine of {probing.RAD_S:g} rad/s for the first actuator and {probing.RAD_S_MORE:g} rad/s more for each next",
    f"at most {probing.LARGEST:g} scaled units of a surface and {probing.LARGEST_THRUST:g} of thrust",
    f"held within {probing.LARGEST:g} units of a stop is not judged",
    f"a jam if it is at most {offset_detection.NEAR_SIGMAS:g} deviations above 0 for {evidence.MEAN_S:g} s",
    f"an engine's sine is {probing.ENGINE_SLOWER:g} times slower",
    f"as large as a decision within {probing.WITHIN_S:g} s needs",
    f"used again when the sum is above {probing.CERTAIN:g}",
    f"the same to the last digit for {sensor_guard.REPEATS_S:g} s",
    f"drawn within {sensor_guard.RECALL_S:g} s to that at which the angle of attack carries the weight",
    f"what a gust of {sensor_guard.UNSEEN_GUST:g} m/s does by that angle",
    f"less that over the ground, through a lag of {initial_records._SINK_TIME_S:g} s",
    f"more than {mode_trim._BANK_MAX:g} rad of bank or {mode_trim._BETA_MAX:g} rad of sideslip is no trim",
    f"so that the path follows within {scaling.PATH_LAG_S:g} s",
    f"(process noise {estimator.REVERSAL_NOISE:g}, later {estimator.JAM_NOISE:g} scaled units",
    f"searched from {mode_trim._AIRSPEEDS[0]:g} to {mode_trim._AIRSPEEDS[-1]:g} times the reference airspeed",
    f"Margin beyond {mode_trim._MARGIN_ENOUGH:g} does not count",
    f"If no level trim has a margin of {mode_trim._MARGIN_OF_LEVEL_FLIGHT:g}",
    f"a path within {mode_trim._NEARLY_LEVEL:g} rad of level",
    f"margin counts up to {mode_trim._MARGIN_OF_A_GLIDE:g}, and sinking at the reference airspeed would cost "
    f"{mode_trim._MARGIN_FOR_SLOPE:g}",
    f"the margin of level flight is {mode_trim._MARGIN_TO_DESCEND:g}",
    f"has moved by {jam_detection.REDESIGN_AFTER:g} units, the regulator is designed again",
    f"one up to {mode_trim._BEYOND_STOPS - 1:.0%} beyond them".replace("%", " %"),
    f"Where the authority over the axis is less than {scaling._AMPLE:g} times that",
]


@pytest.mark.parametrize("sentence", SENTENCES)
def test_the_page_says_the_numbers_of_the_law(sentence: str) -> None:
    assert sentence in PAGE


def test_the_check_can_fail() -> None:
    """Negative control: another threshold is not on the page."""
    assert not any(sentence.replace("0.06", "0.07") in PAGE for sentence in SENTENCES if "0.06" in sentence)
