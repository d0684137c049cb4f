"""The page of a design model from logs: the story, what was measured beside what the model predicts where it was not fitted,
whether what is left is white, and each coefficient."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from testbed.logs.identification import WINDOW_S, Factor, Identified, Validation
from testbed.logs.identified_words import made_in, said_of, story, value_of
from testbed.logs.output_error import STRETCH_S
from testbed.logs.page import cell, residuals_picture
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


def write_page(found: Identified, model: str, logs: Sequence[str], file: Path, within: Path) -> Path:
    """Write the page; returns its file. Raises OSError."""
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
        f"fit over {STRETCH_S:g} s": lambda v: cell(v.simulated),
        f"fit over {STRETCH_S:g} s of the aircraft's model": lambda v: cell(v.simulated_before),
    }
    name = f"Design model of {model} from logs"
    parts = [html.opening(name, story(found)), tag("h2", "Where it was not fitted")]
    if len(found.output.kept[0]):
        parts.append(html.picture(residuals_picture(found.output.kept), _KEPT))
    parts += [
        html.picture(picture(found.validation), _RATES), html.listing(found.validation, fits),
        html.note("Fit: 1 - rms error / rms. Theil: 0 is perfect, 1 worst."),
        tag("h2", "Coefficients"), html.listing(found.factors, columns),
        html.note("A factor of 1 is the aircraft's model. That by output error is taken, where there is one."),
    ]  # fmt: skip
    return html.write_page(file, name, parts, within=within)


def picture(validation: Sequence[Validation]) -> bytes:
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
