"""The reference is written from the code: nothing is missing from it, and what the code does not explain is refused."""

from __future__ import annotations

import re
from pathlib import Path

import law_numbers
import log_meanings
import model_tables
import property_tables
import pytest
import reference_tables
import site_hooks
from command_line import ROOT
from pydantic import Field

from testbed.aircraft.description import Aircraft
from testbed.controllers.config import TABLE as CONTROLLERS
from testbed.failures import TABLE as FAILURES
from testbed.inputs.base import Number, Positive, Settings
from testbed.metrics import TABLE as METRICS
from testbed.scenario.model import Scenario
from testbed.sensors.settings import SENSORS, Sensors
from testbed.studies.model import Search, Sweep

DOCS = ROOT / "docs"
PAGES = sorted(page for page in DOCS.rglob("*.md") if "generate" not in page.parts)


class Inner(Settings):
    """What lies inside."""

    depth_m: Number = Field(default=2.0, ge=1, lt=3)
    """How deep."""


class Outer(Settings):
    """A model with one of each."""

    width_m: Positive
    inner: Inner = Inner()
    many: dict[str, tuple[int, ...]] = {}  # noqa: RUF012  (pydantic copies it)
    silent: str = "yes"


def test_a_models_keys_have_type_default_range_and_meaning() -> None:
    rows = model_tables.table(Outer).splitlines()[2:]
    assert rows == [
        "| `width_m` | number, above 0 | required |  |",
        "| `inner` | mapping | `{depth_m: 2}` | What lies inside. |",
        "| `many` | names, each with: list of whole number | none |  |",
        "| `silent` | text | `yes` |  |",
    ]
    assert "| `depth_m` | number, at least 1 and below 3 | `2` | How deep. |" in model_tables.table(Inner)


@pytest.mark.parametrize("model", [Scenario, Sweep, Search, Aircraft, *CONTROLLERS.values()])
def test_every_key_is_explained_by_the_code(model: type[Settings]) -> None:
    """By a docstring below it, or by that of the mapping that it holds."""
    said = model_tables.meanings(model)
    assert not [name for name in model.model_fields if name != "type" and not said.get(name)]


def test_every_command_and_option_is_there() -> None:
    page = reference_tables.commands()
    for name, command in reference_tables.subcommands().items():
        section = page.split(f"## `{name}`\n")[1].split("\n## ")[0]
        options = {option for action in command._actions for option in action.option_strings} - {
            "-h",
            "--help",
        }
        assert all(f"`{option}" in section for option in options)


def test_an_options_default_is_said_once() -> None:
    rows = [line for line in reference_tables.commands().splitlines() if line.startswith("| `")]
    assert any("(default: 0.1)" in row for row in rows)
    assert not [row for row in rows if "%(" in row or row.count("default") > 1 or "|  |" in row]


def test_what_a_table_has_of_a_docstring_is_a_whole_sentence() -> None:
    faults = model_tables.alternatives(Sensors, "faults")
    first = {
        name: reference_tables.first_line(it)
        for name, it in [*FAILURES.items(), *METRICS.items(), *faults.items()]
    }
    assert not [name for name, line in first.items() if not line.endswith((".", ".)"))]


def test_every_metric_is_there_with_a_unit() -> None:
    rows = [line.split(" | ") for line in reference_tables.metrics().splitlines()[2:]]
    assert [row[0].strip("|` ") for row in rows] == list(METRICS)
    assert all(row[1].strip() for row in rows)


def test_every_log_column_is_explained_once() -> None:
    table = reference_tables.log_columns()
    columns = re.findall(
        r"`([^`]+)`[,|]? ?", "\n".join(line.split(" | ")[0] for line in table.splitlines()[2:])
    )
    assert log_meanings.unused(columns) == []
    with pytest.raises(KeyError, match="0 meanings"):
        log_meanings.meaning("nonsense_m")


def test_a_property_that_nobody_explained_is_refused() -> None:
    known = dict(list(property_tables._SERVO.items())[:-1])
    with pytest.raises(KeyError, match="fail_stuck"):
        property_tables._table(reference_tables.markdown, "servo", known)


def test_every_table_that_a_page_asks_for_is_made() -> None:
    asked = 0
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        asked += len(site_hooks._TABLE.findall(text))
        made = site_hooks.on_page_markdown(text)
        assert "<!-- table" not in made and "<!-- keys" not in made and "<!-- file" not in made
    assert asked > 10
    with pytest.raises(KeyError):
        site_hooks.on_page_markdown("<!-- table: nonsense -->")


def test_every_setting_of_a_sensor_is_on_its_page() -> None:
    """The page writes U for the sensor's unit: one row serves all sensors."""
    page = (DOCS / "reference" / "sensors.md").read_text(encoding="utf-8")
    fields = SENSORS["gyro"].model_fields
    assert not [name for name in fields if f"`{name.replace('_deg_s', '_U')}`" not in page]


def test_every_package_says_what_it_is() -> None:
    rows = reference_tables.packages().splitlines()[2:]
    assert len(rows) > 15
    assert not [row for row in rows if row.endswith("|  |")]


def test_every_number_of_the_law_says_what_it_is() -> None:
    numbers = list(law_numbers.numbers())
    assert len(numbers) > 80 and ("sensor_guard", "REPEATS_S = 0.2") in [each[:2] for each in numbers]
    # Iterations of Gauss and Newton, whose name says all.
    assert {each.said for each in numbers if not each.meaning} <= {"ITERATIONS = 12"}


def test_equations_become_mathml() -> None:
    pytest.importorskip("latex2mathml", reason="the site's own dependency: pip install '.[docs]'")
    made = site_hooks.on_page_content(r'<p>a <span class="arithmatex">\(B_m \lt 1\)</span></p>')
    assert "<math" in made and "arithmatex" not in made


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_each_page_says_first_what_it_is_for(page: Path) -> None:
    _, _, body = page.read_text(encoding="utf-8").partition("\n")
    first = re.sub(r"<!--.*?-->", "", body, flags=re.DOTALL).strip().splitlines()[0]
    assert first.startswith("This page ")
