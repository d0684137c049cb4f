"""Figure 6: an estimate is drawn where the controller makes one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from figure_flights import broken, panels
from handmade import flight_of, injection, level_log

from testbed.common.signals import Belief
from testbed.reporting.comparison.compare import Comparison
from testbed.reporting.comparison.page import columns_of
from testbed.reporting.comparison.page import groups as of_comparison
from testbed.reporting.figures import plot
from testbed.reporting.page import groups
from testbed.reporting.panels import shown_log


def _labels(flight: object) -> set[str]:
    return {line.get_label() for axes in panels(plot(flight, "effectiveness")) for line in axes.lines}


def test_a_controller_that_estimates_nothing_has_no_estimate() -> None:
    assert "believed" not in _labels(broken())


def test_an_estimate_is_drawn_with_its_threshold() -> None:
    log = level_log()
    log["elevon_effectiveness_estimate"][400:] = 0.5
    labels = _labels(flight_of(log))
    assert "believed" in labels and any(label.startswith("threshold") for label in labels)


def test_thresholds_of_surfaces_and_engines_share_the_words_as_their_lines_look_alike() -> None:
    log = level_log()
    log["elevon_effectiveness_estimate"][400:] = 0.5
    made = flight_of(log)
    law = {"type": "adaptive_inversion", "threshold": 0.06, "propeller_threshold": 0.12}
    two = made.scenario.model_validate({**made.scenario.model_dump(), "controller": law})
    shown = _labels(replace(made, scenario=two))
    assert {label for label in shown if label.startswith("threshold")} == {"threshold 0.06 / 0.12"}


def test_what_is_true_is_what_the_actuator_does_for_its_command() -> None:
    """An actuator that is held has no line of it from then on, and the panel says so; in the page and in the figure."""
    made = flight_of(level_log(), [injection(3.0, type="stuck")])
    failure = {"type": "stuck", "actuator": "elevon", "at_s": 3.0}
    scenario = made.scenario.model_validate({**made.scenario.model_dump(), "failures": [failure]})
    held = replace(made, scenario=scenario)
    axes = panels(plot(held, "effectiveness"))[0]
    (true,) = (line for line in axes.lines if line.get_label() == "true")
    time, values = (np.asarray(part, dtype=float) for part in true.get_data())
    assert (values[time < 3.0] == 1.0).all() and np.isnan(values[time >= 3.0]).all()
    assert "does not follow its command" in {text.get_text() for text in axes.texts}
    (group,) = (group for group in groups(held, shown_log(held)) if group["name"] == "effectiveness")
    assert "does not follow its command from 3.0 s on" in group["panels"][0]["title"]


def test_what_is_believed_again_and_again_is_written_once() -> None:
    log = level_log()
    log["elevon_belief"] = np.zeros(len(log["time_s"]))
    for first in (200, 400, 600):
        log["elevon_belief"][first : first + 50] = Belief.late
    axes = panels(plot(flight_of(log), "effectiveness"))[0]
    assert [text.get_text() for text in axes.texts].count("believed late") == 1


def test_compared_flights_share_what_is_true_only_where_it_is_the_same() -> None:
    estimating = level_log()
    estimating["elevon_effectiveness_estimate"][400:] = 0.5
    weak = {name: values.copy() for name, values in estimating.items()}
    weak["elevon_effectiveness"][300:] = 0.2
    shorter = {name: values[:800] for name, values in estimating.items()}
    for other, labels in ((shorter, ["true"]), (weak, ["true, a", "true, b"])):
        compared = Comparison([flight_of(estimating), flight_of(other)], ["a", "b"])
        (group,) = (
            g for g in of_comparison(compared, columns_of(compared.flights)) if g["name"] == "effectiveness"
        )
        said = [series["label"] for series in group["panels"][0]["series"]]
        assert said == [*labels, "a", "b"]
