"""Change the failures of a flight in flight: what is broken by hand replaces what it would overlap."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from testbed.aircraft.description import Aircraft
from testbed.failures import Failure, held_by, meet, stream_names, windows
from testbed.injection.injector import Planned
from testbed.inputs.problems import BadInput, Problem


def with_failure(planned: Sequence[Planned], failure: Failure, aircraft: Aircraft) -> list[Planned]:
    """The plan with one more failure.

    A failure that holds one of the new one's properties ends when the new one starts. One of the same type that holds no other
    property is replaced by it. If another is planned to hold one of them later, the new one ends then.

    Raises:
        BadInput: what it would end cannot be undone; it starts at no stated time or ends after another one is planned, and they
            hold the same property.
    """
    failure = _until_the_next(planned, failure, aircraft)
    if failure.at_s is None:
        return [*planned, Planned(failure)]
    names = held_by(failure, aircraft)
    # What would start at the same instant has been overtaken before it began.
    others = [
        one
        for one in planned
        if one.failure.at_s != failure.at_s or not names & held_by(one.failure, aircraft)
    ]
    made = list[Planned]()
    for one, (its, window, meets) in zip(others, _beside(others, failure, aircraft), strict=True):
        # One of its type that holds more would be replaced, and leave something broken that nothing mends.
        left = one.failure.until_s is None and window[1] == failure.at_s and not its <= names
        made += _ended(one, failure.at_s) if its & names and (left or meets) else [one]
    return _renumbered([*made, Planned(failure)])


def mended(planned: Sequence[Planned], actuator: str, time_s: float) -> list[Planned]:
    """The plan in which everything that has broken this actuator ends now.

    Raises:
        BadInput: it has no failure now, or one that cannot be undone.
    """
    broken = [one for one in planned if _breaks(one, actuator, time_s)]
    if not broken:
        others = sorted(
            {str(one.injection.actuator) for one in planned if one.injection and one.injection.active}
        )
        what = f"{actuator} has no failure now"
        raise BadInput([Problem(what, "mend", expected=f"one of {', '.join(others)}" if others else "")])
    made = [new for one in planned for new in (_ended(one, time_s) if one in broken else [one])]
    return _renumbered(made)


def _breaks(one: Planned, actuator: str, time_s: float) -> bool:
    """Whether a failure breaks an actuator now, or is just about to."""
    injection = one.injection
    if injection is None or injection.actuator != actuator:
        return False
    return injection.active or (not injection.started and one.failure.at_s == time_s)


def _ended(one: Planned, at_s: float) -> list[Planned]:
    """The failure with its end at this time; none if it would not have begun by then. Raises BadInput."""
    started = one.injection is not None and one.injection.started
    if not one.failure.undone and started:
        what = f"{one.failure.type} of {one.failure.actuator} cannot be undone"
        raise BadInput([Problem(what, path="failure", expected="a failure of another actuator")])
    if one.failure.window_s[0] >= at_s or not one.failure.undone:
        return []
    return [one._replace(failure=one.failure.model_copy(update={"until_s": at_s}))]


def _until_the_next(planned: Sequence[Planned], failure: Failure, aircraft: Aircraft) -> Failure:
    """The failure, with an end where another is planned to hold a property of it later."""
    names, start_s = held_by(failure, aircraft), failure.window_s[0]
    later = [
        window[0]
        for its, window, meets in _beside(planned, failure, aircraft)
        if its & names and meets and (window[0] > start_s or failure.at_s is None)
    ]
    if not later:
        return failure
    if failure.at_s is None or failure.until_s is not None or not failure.undone:
        what = "holds a property that another failure of this flight holds in the same time"
        raise BadInput([Problem(what, "inject", path="failure", expected="at_s, and an end before it")])
    return failure.model_copy(update={"until_s": min(later)})


def _beside(
    planned: Sequence[Planned], failure: Failure, aircraft: Aircraft
) -> Iterator[tuple[frozenset[str], tuple[float, float], bool]]:
    """Of each that is planned: the properties that it holds, when it holds them [s], and whether the failure does so meanwhile."""
    each = [*(one.failure for one in planned), failure]
    held = [held_by(one, aircraft) for one in each]
    lasting = windows(each, held)
    return (
        (its, window, meet(window, lasting[-1])) for its, window in zip(held[:-1], lasting[:-1], strict=True)
    )


def _renumbered(plan: list[Planned]) -> list[Planned]:
    """The plan, or BadInput if one that has started would have drawn other random numbers."""
    for one, stream in zip(plan, stream_names([one.failure for one in plan]), strict=True):
        if one.injection and one.injection.started and one.failure.draws and one.injection.stream != stream:
            what = f"the random numbers of {one.failure.type} at {one.failure.at_s:g} s depend on one that would go"
            raise BadInput([Problem(what, path="failures")])
    return plan
