"""summary.json of a search: what each part found, and for a probability what its variants' parts say together.

Its contents do not depend on the clock or the machine, nor on how often the search was interrupted.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from testbed.common.files import plain
from testbed.reliability import FailureProbability, SmallestFailure, Step
from testbed.studies.drawing.builder import Task
from testbed.studies.search.plan import Part, SearchPlan
from testbed.studies.search.run import Found, broken_names

Summary = dict[str, Any]


def summarize(plan: SearchPlan, found: Sequence[Found]) -> Summary:
    """Contents of summary.json; a number that is not finite is None.

    `found`, `distance` and `probability` are those of the first variant: its nearest failure, and its probability.
    """
    parts = [_part(plan, each) for each in found]
    variants = [_variant(plan, number, found) for number in range(len(plan.variants))]
    first = nearest([part for part in parts if part["variant"] == 0])
    return plain(
        {
            "search": plan.name,
            "goal": plan.study.goal,
            "requirement": plan.study.requirement,
            "seed": plan.study.seed,
            "budget": plan.study.budget,
            "cov": plan.study.cov,
            "method": plan.study.method,
            "varied": [each.path for each in plan.parts[0].space.coordinates],
            "found": first is not None,
            "distance": None if first is None else first["distance"],
            "probability": variants[0]["probability"],
            "flights": sum(each.flights for each in found),
            "variants": variants,
            "parts": parts,
        }
    )


def nearest(parts: Sequence[Summary]) -> Summary | None:
    """The part that found the nearest failure; None if none did."""
    return min((part for part in parts if part["found"]), key=lambda part: part["distance"], default=None)


def _part(plan: SearchPlan, found: Found) -> Summary:
    part, answer, record = found.part, found.answer, found.record
    said: Summary = {
        "label": plan.label(part),
        "variant": part.variant,
        "options": dict(part.options),
        "weight": part.weight,
        "flights": found.flights,
        "without_result": found.without_result,
        "found": record is not None,
        "distance": answer.distance,
        "reason": answer.reason,
    }
    if record is not None and answer.design_point is not None:
        said |= {
            "run": record.run,
            "seed": record.seed,
            "outcome": record.outcome,
            "robustness": record.robustness,
            "broken": broken_names(plan, record),
            "beyond": part.space.beyond(answer.design_point),
            "point": _point(part, answer.design_point),
        }
        own = plan.builder.own_controller(Task(0, part.variant, 0, {}))
        said |= {} if own is None else {"own_controller": own.reference}
    if isinstance(answer, SmallestFailure):
        said |= {
            "path": [_step(part, step) for step in answer.path],
            "independent": answer.independent,
            "upper_bound": answer.upper_bound,
        }
    else:
        said |= {
            "probability": _probability([(answer, 1.0)]),
            "levels": [vars(level) for level in answer.levels],
        }
    return said


def _step(part: Part, step: Step) -> Summary:
    coordinates = _coordinates(part, step.point)
    return {"flights": step.evaluations, "distance": step.distance, "coordinates": coordinates}


def _coordinates(part: Part, u: np.ndarray) -> dict[str, float]:
    return {each.path: each.distance(float(x)) for each, x in zip(part.space.coordinates, u, strict=True)}


def _point(part: Part, u: np.ndarray) -> dict[str, Summary]:
    """The design point: value, coordinate, share of the squared distance, and how likely a value at least this far is."""
    coordinates = _coordinates(part, u)
    total, values = float(u @ u), part.space.values(np.array([u]))[0]
    return {
        each.path: {
            "value": values[each.path],
            "nominal": each.nominal,
            "origin": each.origin,
            "coordinate": coordinates[each.path],
            "share": coordinates[each.path] ** 2 / total if total else 0.0,
            "beyond": each.beyond(coordinates[each.path]),
        }
        for each in part.space.coordinates
    }


def _variant(plan: SearchPlan, number: int, found: Sequence[Found]) -> Summary:
    """A variant: the nearest failure of its parts, and by the law of total probability how likely one is."""
    own = [each for each in found if each.part.variant == number]
    distance = min((each.answer.distance for each in own if each.record is not None), default=math.inf)
    answers = [(each.answer, each.part.weight) for each in own if isinstance(each.answer, FailureProbability)]
    return {
        "label": plan.variants[number].label,
        "found": math.isfinite(distance),
        "distance": distance,
        "flights": sum(each.flights for each in own),
        "probability": _probability(answers) if answers else None,
    }


def _probability(answers: Sequence[tuple[FailureProbability, float]]) -> Summary:
    """Estimate, interval and coefficient of variation of sum(weight * P); the ends of the interval are the sums of the ends.

    `plain_flights` are those that plain sampling needs for the same coefficient of variation, (1 - P) / (P cov^2).
    """
    estimate = sum(weight * answer.probability for answer, weight in answers)
    variance = sum(
        (weight * answer.probability * answer.cov) ** 2 for answer, weight in answers if answer.probability
    )
    cov = math.sqrt(variance) / estimate if estimate else math.inf
    return {
        "estimate": estimate,
        "low": sum(weight * answer.interval[0] for answer, weight in answers),
        "high": sum(weight * answer.interval[1] for answer, weight in answers),
        "coefficient_of_variation": cov,
        "converged": all(answer.converged for answer, _ in answers),
        "flights": sum(answer.evaluations for answer, _ in answers),
        "plain_flights": (1.0 - estimate) / (estimate * cov**2)
        if estimate and 0.0 < cov < math.inf
        else math.inf,
    }
