"""What a kind of study is, and what all of them do alike.

A kind is a module of this package with the functions of `Kind`, and a line in `load.STUDIES`: `sweep` and `search` are two.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

from testbed.common.files import slug
from testbed.common.writing import write
from testbed.inputs.overrides import Option
from testbed.studies.plan import Plan
from testbed.studies.run import Flights, Options


class Kind(Protocol):
    """One kind of study. Its plan says each flight, and `studies.run.fly_into` flies them into its folder."""

    prepare: Callable[..., tuple[Any, Path]]
    """(file, out, settings, *, seed, resume, controllers, and its own options): the checked plan, and the folder (`folder_of`)."""

    def fly(self, plan: Any, folder: Path, options: Options, *, resume: bool) -> Flights:
        """Fly what the folder does not have, and write its table. Raises as `fly_into`."""

    def finish(self, plan: Any, folder: Path, flights: Flights, *, figures: bool) -> dict[str, Any]:
        """Write summary.json, figures and report; returns the summary.

        Figures or a report that cannot be made are a warning, `reporting.attempt.NotShown`.
        """

    def rebuild(self, folder: Path) -> dict[str, Any]:
        """Write again what `finish` writes, without flying; returns the summary. Raises BadInput when there is nothing."""

    def answer(self, summary: Mapping[str, Any]) -> Sequence[str]:
        """What is printed: the answer in sentences, and its numbers."""

    def met(self, summary: Mapping[str, Any]) -> bool:
        """Whether everything was as required, which is exit status 0, else 1."""


def folder_of(plan: Plan, out: str | Path | None) -> Path:
    """The folder of a study: `out`, or by default runs/ with its name."""
    return Path(out) if out is not None else Path("runs") / slug(plan.name, otherwise=plan.study.word)


def changes(
    settings: Sequence[str], by_path: Mapping[str, Any] | None = None, **own: int | None
) -> list[str]:
    """Changes of a study's file, each KEY=VALUE as `--set` takes them.

    Args:
        settings: those given so.
        by_path: others by dotted paths.
        own: keys with an option of their own; those that are None are left out.
    """
    others = [f"{path}={json.dumps(value)}" for path, value in (by_path or {}).items()]
    options = [Option(f"{name}={value}") for name, value in own.items() if value is not None]
    return [*settings, *others, *options]


def write_summary(summary: Mapping[str, Any], folder: Path) -> None:
    """Write summary.json, whole or not at all."""
    text = json.dumps(summary, indent=2, sort_keys=True, ensure_ascii=False, allow_nan=False)
    write(folder / "summary.json", text + "\n")
