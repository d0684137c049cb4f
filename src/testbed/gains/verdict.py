"""Whether a design has what was asked for, and what would help where it has not."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from testbed.gains.candidates import GUSTS, OFFSETS
from testbed.gains.choice import Tolerance


@dataclass(frozen=True)
class ActuatorDesign:
    """What is predicted for one actuator.

    Attributes:
        position: at the trim [scaled].
        noise: standard deviation of its estimate by errors that change within a flight [1].
        offset: the same by errors that last [1].
        bias: what the design model's own error here, and known biases, add to its estimate [1].
        convergence_s: until 5 % of the first error are left, three time constants: by (22), for the default law in flights.
        detection_s: from its total loss to its flag, the median of flights; infinite if it is not flagged in half of them.
        soonest_s, latest_s: the range of these flights.
        met: whether a gain was found whose noise and false alarms are tolerable.
        shares: standard deviation by each error, the largest first.
    """

    name: str
    kind: str
    position: float
    noise: float
    offset: float
    bias: float
    convergence_s: float
    detection_s: float
    soonest_s: float
    latest_s: float
    met: bool
    shares: tuple[tuple[str, float], ...]

    @property
    def deviation(self) -> float:
        """Standard deviation of its estimate, all errors together [1]."""
        return math.hypot(self.noise, self.offset)

    @property
    def lowest(self) -> float:
        """Lowest estimate that errors which last are expected to cause [1]."""
        return 1.0 + min(self.bias, 0.0) - OFFSETS * self.offset


def shortcomings(actuators: Sequence[ActuatorDesign], tolerance: Tolerance) -> list[str]:
    """Why what is asked cannot be had, in sentences; none if it can."""
    return _together((one.name, text) for one in actuators for text in _shortcomings(one, tolerance))


def advice(actuators: Sequence[ActuatorDesign], tolerance: Tolerance) -> list[str]:
    """What would help each actuator that falls short: more deflection at the trim, or less of its largest error."""
    return _together((one.name, text) for one in actuators for text in _advice(one, tolerance))


def _together(sentences: Iterable[tuple[str, str]]) -> list[str]:
    """`names: sentence`, each sentence once."""
    names: dict[str, list[str]] = {}
    for name, sentence in sentences:
        names.setdefault(sentence, []).append(name)
    return [f"{', '.join(of)}: {sentence}" for sentence, of in names.items()]


def _shortcomings(one: ActuatorDesign, tolerance: Tolerance) -> Iterator[str]:
    if one.offset > tolerance.deviation:
        yield (
            f"errors that last move the estimate by {one.offset:.2g} (1 sigma) whatever the gains; tolerated are "
            f"{tolerance.deviation:g}"
        )
    if one.lowest <= 0.0:
        yield "errors that last can bring the estimate of a healthy actuator to zero"
    if not one.met:
        yield "no gain keeps noise and false alarms within what is tolerated"
    if tolerance.within_s is not None and one.convergence_s > tolerance.within_s:
        yield (
            f"with the gain that noise allows, the estimate converges in {one.convergence_s:.2g} s, not within "
            f"{tolerance.within_s:g} s"
        )
    if math.isinf(one.detection_s):
        yield "a total loss would not be flagged"


def _advice(one: ActuatorDesign, tolerance: Tolerance) -> Iterator[str]:
    factor = _short_by(one, tolerance)
    if math.isinf(one.detection_s) and one.shares:
        yield f"a higher gain, for which {one.shares[0][0]} must be less, or the position at the trim larger"
    if factor <= 1.0:
        return
    yield (
        f"a position at the trim of {factor * one.position:.3g} scaled units instead of {one.position:.3g}, by another airspeed "
        "or centre of gravity"
    )
    if one.shares:
        name, share = one.shares[0]
        better = "air data that know it" if name == GUSTS else f"less {name}"
        yield f"{better}, which makes {share:.2g} of the deviation of {one.deviation:.2g}"
    if abs(one.bias) > tolerance.deviation:
        yield f"a design model of this trim: the present one moves the estimate by {one.bias:+.2g}"


def _short_by(one: ActuatorDesign, tolerance: Tolerance) -> float:
    """By what the position would have to be larger, 1 or less if it suffices: deviations go with 1/a, T x variance with 1/a^2."""
    lasting = max(one.offset / tolerance.deviation, OFFSETS * one.offset - min(one.bias, 0.0))
    slow = (
        math.sqrt(one.convergence_s / tolerance.within_s)
        if tolerance.within_s and math.isfinite(one.convergence_s)
        else 0.0
    )
    return max(lasting, slow, 0.0 if one.met else one.deviation / tolerance.deviation)
