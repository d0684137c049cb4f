"""Figures of a sweep: there, not blank, and of the right numbers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from sweep_files import fly_here, table, written

from testbed.reporting.words import setting
from testbed.studies.load import load_sweep
from testbed.studies.plan import Plan
from testbed.study_reports.sweep.figures import TABLE, draw_sweep

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
        assert len(set(labels)) >= 2 or name == "map", (
            name
        )  # the variants, or what the lines of a variant are


def test_probabilities_are_those_of_the_table(flown: Flown) -> None:
    _, frame, _ = flown
    figure = TABLE["probabilities"](*flown)
    assert figure is not None
    drawn = np.concatenate([np.asarray(line.get_xdata(), dtype=float) for line in figure.axes[0].lines])
    expected = frame.groupby("controller.type", observed=True)["passed"].mean()
    assert set(np.round(expected, 9)) <= set(np.round(drawn, 9))


def test_the_share_that_passes_is_along_each_varied_value(flown: Flown) -> None:
    plan, _, _ = flown
    figure = TABLE["pass_share"](*flown)
    assert figure is not None
    panels = {axes.get_xlabel(): axes for axes in figure.axes if axes.get_visible()}
    assert len(panels) == len(plan.paths)
    x, share = (np.asarray(v, dtype=float) for v in panels[setting("failures.0.value")].lines[0].get_data())
    assert (share[x < 0.4] == 0).all() and (share[x > 0.6] == 1).all()  # what a made-up flight does


def test_endings_and_variants_are_told_apart_by_more_than_colour(flown: Flown) -> None:
    for name in ("probabilities", "pass_share"):
        figure = TABLE[name](*flown)
        assert figure is not None
        lines = [
            line for line in figure.axes[0].lines if line.get_marker() not in ("", "None", "|", "_", None)
        ]
        assert {line.get_marker() for line in lines} >= {"o", "s"}, name
    figure = TABLE["map"](*flown)
    assert figure is not None
    counts = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert [words.split()[0] for words in counts] == ["passed", "missed"]


def test_a_figure_with_nothing_to_show_is_left_out(flown: Flown, tmp_path: Path) -> None:
    plan, frame, _ = flown
    few = frame[frame["run"] < 19].drop(columns="detection_delay_s")
    drawn = {
        file.stem for file in draw_sweep(plan, few, tmp_path)
    }  # without histories, too few for sensitivity
    assert drawn == {"probabilities", "map", "pass_share"}
