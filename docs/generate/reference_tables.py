"""Tables of the reference pages other than the keys of a model: commands, controllers, metrics, log columns, sensors."""

from __future__ import annotations

import argparse
import ast
import html
import inspect
import re
import textwrap
import tomllib
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

import equations
import law_numbers
import log_meanings
import model_tables
import property_tables

from testbed.aircraft.description import load_aircraft
from testbed.cli.commands import parser
from testbed.flight.columns import all_columns
from testbed.metrics import TABLE as METRICS
from testbed.scenario.model import Scenario
from testbed.sensors.channels import CHANNELS
from testbed.sensors.settings import MEMS, Sensors

_ROOT = Path(__file__).parents[2]


def markdown(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A Markdown table."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(map(model_tables.cell, line))} |" for line in lines)


def first_line(entry: object) -> str:
    """First line of a docstring."""
    return inspect.cleandoc(getattr(entry, "__doc__", None) or "").partition("\n")[0]


def commands() -> str:
    """A section for each command: its usage, what it does, its options."""
    return "\n\n".join(_command(name, command) for name, command in subcommands().items())


def subcommands() -> dict[str, argparse.ArgumentParser]:
    """Each command's own parser."""
    (actions,) = (a for a in parser()._actions if isinstance(a, argparse._SubParsersAction))
    return dict(actions.choices)


def top_options() -> str:
    """Options of the program itself."""
    rows = list(_options(parser()))
    return markdown(("option", "meaning"), rows) if rows else ""


def _command(name: str, command: argparse.ArgumentParser) -> str:
    does = (command.description or "").strip()
    does = does[:1].upper() + does[1:] + ("" if does.endswith(".") else ".")
    options = markdown(("argument", "meaning"), _options(command))
    examples = "\n".join(line.strip() for line in (command.epilog or "").splitlines()[1:])
    return (
        f"## `{name}`\n\n{does}\n\n```text\n{_usage(command)}\n```\n\n{options}\n\n```bash\n{examples}\n```"
    )


def _usage(command: argparse.ArgumentParser) -> str:
    """Usage in lines of 76 columns, whatever the terminal's width is."""

    def formatter(prog: str) -> argparse.HelpFormatter:
        return argparse.HelpFormatter(prog, width=76)

    command.formatter_class = formatter  # type: ignore[assignment]
    return textwrap.dedent(" " * len("usage: ") + command.format_usage().removeprefix("usage: ")).rstrip()


def _options(command: argparse.ArgumentParser) -> Iterable[tuple[str, str]]:
    for action in command._actions:
        if isinstance(action, argparse._HelpAction | argparse._SubParsersAction):
            continue
        value = action.metavar or (action.dest.upper() if action.nargs != 0 else "")
        if action.choices and not action.metavar:
            value = "one of " + ", ".join(map(str, action.choices))
        name = ", ".join(action.option_strings) or action.dest
        word = f"{name} {value}" if action.option_strings else f"{action.metavar or name}"
        choices = value if value.startswith("one of") and not action.option_strings else ""
        said = (action.help or "") % vars(action)
        meaning = "; ".join(filter(None, (said, choices)))
        yield f"`{word.strip()}`", html.escape(meaning, quote=False)


def controllers() -> str:
    """A section for each controller: what it is, its settings."""
    return "\n\n".join(
        f"## `{name}`\n\n{model_tables.described(kind)}\n\n{model_tables.table(kind, leave_out=('type',))}"
        for name, kind in model_tables.alternatives(Scenario, "controller").items()
    )


def metrics() -> str:
    """Each metric with its unit and definition."""
    rows = []
    for name, metric in METRICS.items():
        meaning = first_line(metric)
        unit = re.search(r" \[([^\]]+)\]", meaning)
        said = meaning.replace(unit.group(0), "") if unit else meaning
        rows.append((f"`{name}`", unit.group(1) if unit else "", said))
    return markdown(("metric", "unit", "definition"), rows)


def log_columns() -> str:
    """Each column of the v-tail's log with real sensors in moving air; columns of actuators appear once, as `A_...`."""
    aircraft = load_aircraft("vtail")
    first, *others = aircraft.actuators
    of_others = tuple(f"{other}_" for other in others)
    names = [n.replace(first, "A") for n in all_columns(aircraft, _weather()) if not n.startswith(of_others)]
    rows: dict[str, list[str]] = {}
    for name in names:
        rows.setdefault(log_meanings.meaning(name), []).append(f"`{name}`")
    return markdown(
        ("column", "meaning"), ((", ".join(columns), meaning) for meaning, columns in rows.items())
    )


def _weather() -> Scenario:
    """A scenario whose log has every column."""
    aircraft = load_aircraft("vtail")
    return Scenario.model_validate(
        {
            "name": "columns",
            "aircraft": aircraft.name,
            "duration_s": 1,
            "initial": {**aircraft.reference.model_dump(), "heading_deg": 0},
            "sensors": "mems",
            "atmosphere": {"wind_m_s": [1, 0, 0]},
        }
    )


def sensor_channels() -> str:
    """Each sensor: its channels, its unit, and what `mems` sets."""
    rows = []
    for sensor in dict.fromkeys(channel.sensor for channel in CHANNELS):
        of = [channel for channel in CHANNELS if channel.sensor == sensor]
        preset = ", ".join(f"`{key}: {value:g}`" for key, value in MEMS.get(sensor, {}).items())
        rows.append((f"`{sensor}`", ", ".join(f"`{c.name}`" for c in of), f"`{of[0].unit}`", preset))
    return markdown(("sensor", "channels", "unit U", "in `mems`"), rows)


def sensor_faults() -> str:
    """Each type of sensor fault."""
    faults = model_tables.alternatives(Sensors, "faults")
    return markdown(
        ("type", "what it does"), ((f"`{name}`", first_line(kind)) for name, kind in faults.items())
    )


def packages() -> str:
    """The layers of the package from the top, as import-linter checks them, each with its docstring's first line."""
    settings = tomllib.loads((_ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    layers = settings["tool"]["importlinter"]["contracts"][0]["layers"]
    rows = []
    for layer in layers:
        for name in layer.split(" | "):
            module = _ROOT / "src" / "testbed" / name
            file = module / "__init__.py" if module.is_dir() else module.with_suffix(".py")
            doc = ast.get_docstring(ast.parse(file.read_text(encoding="utf-8"))) or ""
            rows.append((f"`{name}`", doc.partition("\n\n")[0]))
    return markdown(("package", "what it is"), rows)


def exports() -> str:
    """The formats of `export`, with what reads each."""
    from testbed.reporting.export import TABLE

    return markdown(
        ("`--to`", "file", "for"),
        ((f"`{name}`", f"`{known.ending}`", known.meaning) for name, known in TABLE.items()),
    )


def numbers_of_the_law() -> str:
    """Each number in the code of the law, with its meaning and source."""
    rows = ((f"`{each.where}`", f"`{each.said}`", each.meaning) for each in law_numbers.numbers())
    return markdown(("in", "number", "what it is, and why it is that"), rows)


TABLES: dict[str, Callable[[], str]] = {
    "commands": commands,
    "top_options": top_options,
    "controllers": controllers,
    "metrics": metrics,
    "packages": packages,
    "log_columns": log_columns,
    "sensor_channels": sensor_channels,
    "sensor_faults": sensor_faults,
    "servo_properties": lambda: property_tables.servo(markdown),
    "motor_properties": lambda: property_tables.motor(markdown),
    "exports": exports,
    "equations": equations.table,
    "numbers_of_the_law": numbers_of_the_law,
}
