"""Figures of a sweep: there, not blank, and of the right numbers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from sweep_files import SWEEP, fly_here, table, written

from testbed.reporting.sweep_figures import TABLE, draw_sweep, remaining_effectiveness
from testbed.sweeps.load import load_sweep
from testbed.sweeps.plan import Plan

Flown = tuple[Plan, pd.DataFrame, Path]


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Flown:
    """A sweep of made-up flights, and its table; some detections are put into it."""
    folder = tmp_path_factory.mktemp("figures")
    plan = load_sweep(written(folder), ["runs=150"])
    frame = table(fly_here(plan, folder / "out"))
    frame["detection_delay_s"] = np.where(frame["run"] % 3 == 0, frame["run"] / 100.0, np.nan)
    return plan, frame, folder / "out"


def test_every_figure_is_drawn_and_not_blank(flown: Flown) -> None:
    from matplotlib.image import imread

    files = draw_sweep(*flown)
    assert [file.stem for file in files] == list(TABLE)
    for file in files:
        ink = imread(file)[..., :3].min(axis=2) < 0.5
        assert 0.0005 < ink.mean() < 0.5


def test_each_figure_says_what_it_shows(flown: Flown) -> None:
    for name, draw in TABLE.items():
        figure = draw(*flown)
        assert figure is not None
        words = [axes.get_xlabel() for axes in figure.axes]
        assert any(words), name
        labels = [text for axes in figure.axes for text in axes.get_legend_handles_labels()[1]]
        assert len(set(labels)) >= 2, name  # the variants, or what the lines of a variant are


def test_probabilities_are_those_of_the_table(flown: Flown) -> None:
    _, frame, _ = flown
    figure = TABLE["probabilities"](*flown)
    assert figure is not None
    drawn = [float(line.get_xdata()[0]) for line in figure.axes[0].lines if len(line.get_xdata()) == 1]
    expected = frame.groupby("controller.type", observed=True)["passed"].mean()
    assert set(np.round(expected, 9)) <= set(np.round(drawn, 9))


def test_survival_is_over_the_effectiveness_that_is_left(flown: Flown) -> None:
    plan, frame, _ = flown
    assert remaining_effectiveness(plan, frame) == "failures.0.value"
    figure = TABLE["survival"](*flown)
    assert figure is not None
    x, share = (np.asarray(values, dtype=float) for values in figure.axes[0].lines[0].get_data())
    assert (share[x < 0.4] == 0).all() and (share[x > 0.6] == 1).all()  # what a made-up flight does


def test_without_an_effectiveness_the_first_varied_number_is_taken(tmp_path: Path) -> None:
    text = SWEEP.replace("failures.0.value: {uniform: [0, 1]}", "failures.0.value: {choice: [0.2]}")
    plan = load_sweep(written(tmp_path, text))
    frame = table(fly_here(plan, tmp_path / "out"))
    assert remaining_effectiveness(plan, frame) == "failures.0.at_s"


def test_a_figure_with_nothing_to_show_is_left_out(flown: Flown, tmp_path: Path) -> None:
    plan, frame, _ = flown
    few = frame[frame["run"] < 20].drop(columns="detection_delay_s")
    drawn = {
        file.stem for file in draw_sweep(plan, few, tmp_path)
    }  # without histories, too few for sensitivity
    assert drawn == {"probabilities", "survival"}
