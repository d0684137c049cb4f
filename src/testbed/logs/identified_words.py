"""A design model from logs in sentences and in numbers."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence

from testbed.common.files import plain
from testbed.logs.identification import COLLINEAR, KEPT_BACK, LARGEST_STD, WINDOW_S, Factor, Identified
from testbed.logs.output_error import STRETCH_S


def story(found: Identified) -> list[str]:
    """What the logs contradict, what they cannot tell, how the model does on what was kept back, and remarks about the logs."""
    unknown = [f.name for f in found.factors if not f.known]
    alike = {
        " and ".join(sorted((f.name, f.alike))): None
        for f in found.factors if f.known and f.inflation > COLLINEAR
    }  # fmt: skip
    fits = [
        f"{v.rate[0]} {v.simulated:.2f} ({v.simulated_before:.2f})"
        for v in found.validation if math.isfinite(v.simulated)
    ]  # fmt: skip
    lines = [
        f"{f.name} is {f.taken:.2f} times what the aircraft's model has{', ' * bool(made)}{made}."
        for f in found.factors if f.contradicted for made in [made_in(found, f)]
    ]  # fmt: skip
    if not lines:
        lines.append("The logs contradict nothing of the aircraft's model.")
    if unknown:
        lines.append(f"Not identifiable, above +-{LARGEST_STD:g}, and kept: {', '.join(unknown)}.")
    if alike:
        lines.append(f"Hardly told apart: {', '.join(alike)}.")
    if fits:
        kept = f"the last {100 * KEPT_BACK:.0f} % of each log, which was not used"
        lines.append(
            f"Fit in {kept}, simulated for {STRETCH_S:g} s (with the aircraft's model): {', '.join(fits)}."
        )
    return [*lines, *found.remarks]


def made_in(found: Identified, factor: Factor) -> str:
    """Which functions of the XML make a coefficient that the logs contradict; empty for another."""
    if factor.name not in found.makers:
        return ""
    return f"made in the XML by {', '.join(map(str, found.makers[factor.name])) or 'nothing'}"


def said_of(factor: Factor) -> str:
    """What the logs say of a coefficient, but for its factor."""
    said = "contradicts the model" if factor.contradicted else ""
    if not factor.known:
        said = f"not identifiable: above +-{LARGEST_STD:g}, kept"
    alike = f"variance {factor.inflation:.0f} times that alone" if factor.inflation > COLLINEAR else ""
    return "; ".join(filter(None, (said, alike)))


def table(found: Identified, logs: Sequence[str]) -> str:
    """What logs say of each coefficient of a design model, and how the model that they give does on what was kept back."""
    lines = [
        "factor on each coefficient of the aircraft's own model, by output error and by equation error, and the "
        f"{WINDOW_S:g} s that told most of it:"
    ]
    for each in found.factors:
        both = f"{value_of(each.simulated, each.simulated_std)}  {value_of(each.value, each.std)}"
        told = f"{logs[each.log]} at {each.from_s:.0f} s"
        lines.append(f"  {each.name:28} {both:30}  {told}  {said_of(each)}".rstrip())
        lines += [f"    {made}"] if (made := made_in(found, each)) else []
    lines.append("on the part that was kept back, without what is constant:")
    for one in found.validation:
        lines.append(
            f"  {one.rate}  fit {one.fit:.2f} (model of the aircraft {one.fit_before:.2f})  Theil {one.theil:.3f}  "
            f"{100 * one.coloured:.0f} % of the residual's correlations are not those of white noise"
        )
    for one in found.validation:
        if math.isfinite(one.simulated):
            before = f"(model of the aircraft {one.simulated_before:.2f})"
            lines.append(f"  {one.rate[0]}  simulated for {STRETCH_S:g} s: fit {one.simulated:.2f} {before}")
    return "\n".join([*lines, *found.remarks])


def value_of(value: float, std: float) -> str:
    """A factor with its standard deviation, in 14 characters; blank where there is none."""
    return f"{value:6.2f} +-{min(std, 99.0):5.2f}" if math.isfinite(value) else 14 * " "


def summary(found: Identified, model: str, logs: Sequence[str]) -> str:
    """summary.json: JSON has no NaN, so what a method does not give is null."""
    courses = ("time_s", "measured", "predicted")
    contents = {
        "model": model,
        "logs": list(logs),
        "story": story(found),
        "factors": {
            f.name: vars(f) | {"log": logs[f.log], "taken": f.taken, "contradicted": f.contradicted}
            for f in found.factors
        },
        "made_by": {name: list(map(str, makers)) for name, makers in found.makers.items()},
        "validation": {
            v.rate: {k: x for k, x in vars(v).items() if k not in courses} for v in found.validation
        },
        "covariance": {
            "output error": {"factors": list(found.output.factors), "matrix": found.output.covariance},
            **{
                rate: {"factors": [f.name for f in found.factors if f.rate == rate], "matrix": matrix}
                for rate, matrix in found.covariances.items()
            },
        },
    }  # fmt: skip
    return json.dumps(plain(contents), indent=2, sort_keys=True, ensure_ascii=False, allow_nan=False) + "\n"
