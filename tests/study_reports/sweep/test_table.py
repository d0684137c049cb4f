"""The table of a sweep: its sentence first in a notebook, its figures by name, and otherwise a DataFrame."""

from __future__ import annotations

import pandas as pd
import pytest
from sweep_files import fly_here, written

import testbed
from testbed.inputs.problems import BadInput
from testbed.studies.load import load_sweep
from testbed.study_reports.sweep.table import SweepTable


@pytest.fixture(scope="module")
def flights(tmp_path_factory: pytest.TempPathFactory) -> pd.DataFrame:
    folder = tmp_path_factory.mktemp("table")
    fly_here(load_sweep(written(folder), ["runs=20"]), folder / "out")
    loaded = testbed.load(folder / "out")
    assert isinstance(loaded, SweepTable)
    return loaded


def test_its_figures_are_drawn_by_name_and_shown(flights: pd.DataFrame) -> None:
    figure = flights.plot()
    assert figure.axes[0].get_xlabel() and figure._repr_png_().startswith(b"\x89PNG")
    assert flights.plot("envelope").axes
    with pytest.raises(BadInput, match="did you mean probabilities"):
        flights.plot("probability")


def test_pandas_still_plots(flights: pd.DataFrame) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("agg")
    axes = flights.plot(x="run", y="altitude_error_max_m")
    assert axes.get_xlabel() == "run"


def test_a_notebook_shows_the_sentence_first(flights: pd.DataFrame) -> None:
    html = flights._repr_html_()
    assert html.startswith(f"<p>{flights.attrs['summary']}</p>") and "<table" in html


def test_a_selection_is_an_ordinary_table(flights: pd.DataFrame) -> None:
    assert type(flights[flights["passed"]]) is pd.DataFrame
    assert type(flights.groupby("passed").mean(numeric_only=True)) is pd.DataFrame
