"""A design model from logs in sentences, in numbers, and as a page."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from testbed.logs.diagnosis import as_json
from testbed.logs.identification import (
    COLLINEAR,
    KEPT_BACK,
    LARGEST_STD,
    WINDOW_S,
    Factor,
    Identified,
    Validation,
)
from testbed.logs.output_error import STRETCH_S
from testbed.logs.page import residuals_picture
from testbed.reporting import html
from testbed.reporting.html import Cell, tag
from testbed.reporting.palette import PALETTE

_KEPT = (
    f"Turning rates of the part that was kept back, measured and as the model that was found simulates them in stretches of "
    f"{STRETCH_S:g} s, and what is left. Time counts through all logs, one after another."
)
_RATES = (
    "Left: their derivatives and that of airspeed in the same part, measured and predicted, without what is constant. "
    "Right: correlation of what is left with itself, later by so much; white noise stays within the grey band 19 times of 20."
)


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
    """summary.json."""
    courses = ("time_s", "measured", "predicted")
    return as_json({
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
    })  # fmt: skip


def write_page(found: Identified, model: str, logs: Sequence[str], out: Path) -> None:
    """Write `report.html` into a folder: the story, what was measured beside what the model predicts where it was not fitted,
    whether what is left is white, and each coefficient. Raises OSError."""
    columns: dict[str, Callable[[Factor], Cell]] = {
        "coefficient": lambda f: f.name,
        "factor by output error": lambda f: value_of(f.simulated, f.simulated_std).strip(),
        "by equation error": lambda f: value_of(f.value, f.std).strip(),
        "variance, times that alone": lambda f: f.inflation,
        "goes most with": lambda f: f"{f.alike} ({f.correlation:+.2f})",
        f"{WINDOW_S:g} s that told most": lambda f: f"{logs[f.log]}, {f.from_s:.0f} s",
        "": lambda f: "; ".join(filter(None, (said_of(f), made_in(found, f)))),
    }
    fits: dict[str, Callable[[Validation], Cell]] = {
        "": lambda v: v.rate,
        "fit": lambda v: v.fit,
        "of the aircraft's model": lambda v: v.fit_before,
        "Theil": lambda v: v.theil,
        "correlations beyond those of white noise": lambda v: v.coloured,
        f"fit over {STRETCH_S:g} s": lambda v: v.simulated,
        f"fit over {STRETCH_S:g} s of the aircraft's model": lambda v: v.simulated_before,
    }
    name = f"Design model of {model} from logs"
    parts = [html.opening(name, story(found)), tag("h2", "Where it was not fitted")]
    if len(found.output.kept[0]):
        parts.append(html.picture(residuals_picture(found.output.kept), _KEPT))
    parts += [
        html.picture(_picture(found.validation), _RATES), html.listing(found.validation, fits),
        html.note("Fit: 1 - rms error / rms. Theil: 0 is perfect, 1 worst."),
        tag("h2", "Coefficients"), html.listing(found.factors, columns),
        html.note("A factor of 1 is the aircraft's model. That by output error is taken, where there is one."),
    ]  # fmt: skip
    html.write_page(out / "report.html", name, parts, within=out)


def _picture(validation: Sequence[Validation]) -> bytes:
    """PNG with a row for each rate: its course, and the correlations of what is left."""
    from matplotlib.figure import Figure

    from testbed.reporting.figures.sheet import png

    figure = Figure(figsize=(10.0, 1.0 + 1.7 * len(validation)), layout="constrained")
    made = figure.subplots(len(validation), 2, squeeze=False, sharex="col", width_ratios=(3.0, 1.0))
    for (course, right), one in zip(made, validation, strict=True):
        whole = np.diff(one.time_s, append=np.inf) < 2.0 * np.median(np.diff(one.time_s))
        for label, values, colour, style in (
            ("measured", one.measured, "truth", "-"), ("predicted", one.predicted, "belief", "--"),
        ):  # fmt: skip
            drawn = np.where(whole, values, np.nan)  # no line through what was used, or is not known
            course.plot(one.time_s, drawn, color=PALETTE[colour], ls=style, lw=0.8, label=label)
        unit = "m/s2" if one.rate == "u_dot" else "rad/s2"
        course.set_ylabel(f"{one.rate} [{unit}]", parse_math=False)
        lags = np.arange(1, len(one.correlations) + 1) * float(np.median(np.diff(one.time_s)))
        right.axhspan(-one.white, one.white, color="0.5", alpha=0.25, lw=0)
        right.bar(lags, one.correlations, width=0.6 * lags[0], color=PALETTE["missed"])
        right.set_ylim(-1.0, 1.0)
    made[0, 0].legend(loc="lower right", fontsize="small", ncols=2)
    made[-1, 0].set_xlabel("time [s]")
    made[-1, 1].set_xlabel("later by [s]")
    return png(figure)
