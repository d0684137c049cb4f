"""Adopt every fixed-wing aircraft of the jsbsim package, and write the page that lists them with the outcome.

    python benchmarks/adopt_all.py FOLDER
    python benchmarks/adopt_all.py FOLDER --document docs/results/adoption.md
    python benchmarks/adopt_all.py FOLDER --models c172p,737

FOLDER gets an aircraft's folder for each. What is there already is kept, so that a run that was ended goes on. Times are
processor seconds of the adoption's process, so that they depend little on what else the machine does.
"""

from __future__ import annotations

import argparse
import json
import resource
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

from testbed.adoption.entry import adopted_card
from testbed.adoption.source import find_source, package_root
from testbed.aircraft.description import Aircraft, load_aircraft
from testbed.inputs.problems import BadInput

OTHERS = {
    "F450": "a quadrotor", "J246": "a rocket", "Submarine_Scout": "an airship", "ZLT-NT": "an airship", "ah1s": "a helicopter",
    "ball": "a ball", "ballx": "a ball", "blank": "an empty model", "mk82": "a bomb", "paraglider": "a paraglider",
    "pogo-jsbsim": "a tail-sitter on its thrust", "weather-balloon": "a balloon",
}  # fmt: skip
"""Models of the package that are no fixed-wing aircraft."""
LONGEST_S = 30.0


def main(arguments: Sequence[str] | None = None) -> None:
    options = _parser().parse_args(arguments)
    options.folder.mkdir(parents=True, exist_ok=True)
    chosen = options.models.split(",") if options.models else models()
    if options.finished:
        chosen = [model for model in chosen if (options.folder / "outcomes" / f"{model}.json").is_file()]
    outcomes = [_outcome(model, options.folder) for model in chosen]
    adopted = [each for each in outcomes if not each["refusal"]]
    print(
        f"{len(adopted)} of {len(outcomes)} adopted, the slowest in {max(each['cpu_s'] for each in outcomes):.0f} s"
    )
    if options.document:
        options.document.write_text("\n".join(page(outcomes, options.folder)) + "\n", encoding="utf-8")


def models() -> list[str]:
    """The fixed-wing aircraft of the package."""
    folders = (each for each in (package_root() / "aircraft").iterdir() if each.is_dir())
    return sorted((each.name for each in folders if each.name not in OTHERS), key=str.casefold)


def _outcome(model: str, folder: Path) -> dict:
    """What came of one model: refusal (empty if it was adopted), card, seconds; kept in FOLDER/outcomes."""
    kept = folder / "outcomes" / f"{model}.json"
    if kept.is_file():
        return json.loads(kept.read_text())
    before, started = _cpu_s(), time.monotonic()
    card = refusal = ""
    try:
        card = adopted_card(find_source(model, package_root()), folder / model, longest_s=900)
    except BadInput as error:
        refusal = "; ".join(problem.what for problem in error.problems)
    outcome = {"model": model, "refusal": refusal, "card": card, "cpu_s": _cpu_s() - before}
    kept.parent.mkdir(exist_ok=True)
    kept.write_text(json.dumps(outcome, indent=1))
    print(
        f"{model}: {refusal or 'adopted'}, {outcome['cpu_s']:.1f} s of {time.monotonic() - started:.0f} s",
        flush=True,
    )
    return outcome


def _cpu_s() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def page(outcomes: Sequence[dict], folder: Path) -> Iterator[str]:
    """The page, in lines."""
    adopted = [each for each in outcomes if not each["refusal"]]
    slow = [each["model"] for each in adopted if each["cpu_s"] > LONGEST_S]
    yield "# Adopted aircraft"
    yield ""
    yield (
        f"This page lists what `testbed adopt` makes of {len(adopted)} of the {len(models())} fixed-wing models of JSBSim, "
        "without an edit. Seconds are processor time on one core; "
        + (
            f"more than {LONGEST_S:g} s: {', '.join(slow)}."
            if slow
            else f"none takes more than {LONGEST_S:g} s."
        )
    )
    yield ""
    yield "| model | actuators | airspeed m/s | condition number | s |"
    yield "| --- | --- | --- | --- | --- |"
    for each in adopted:
        yield _row(each, load_aircraft(f"{folder}/{each['model']}"))
    yield ""
    yield "The condition number is that of the input matrix, with each actuator in units of its `scale`."
    yield ""
    yield "## Not adopted"
    yield ""
    yield "| model | the refusal |"
    yield "| --- | --- |"
    for each in outcomes:
        if each["refusal"]:
            yield f"| {each['model']} | {each['refusal']} |"
    yield ""
    missing = [model for model in models() if model not in {each["model"] for each in outcomes}]
    if missing:
        yield f"Without an outcome in this run: {', '.join(missing)}."
        yield ""
    yield f"Not fixed-wing aircraft: {', '.join(f'{name} ({what})' for name, what in OTHERS.items())}."


def _row(outcome: dict, aircraft: Aircraft) -> str:
    condition = outcome["card"].split("condition number ")[1].split()[0]
    names = ", ".join(name.replace("_", " ") for name in aircraft.actuators)
    speed = f"{aircraft.reference.airspeed_m_s:.4g}"
    return f"| {outcome['model']} | {names} | {speed} | {condition} | {outcome['cpu_s']:.1f} |"


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path)
    parser.add_argument("--models", help="some of them, separated by commas")
    parser.add_argument("--finished", action="store_true", help="adopt no others than FOLDER has")
    parser.add_argument("--document", type=Path, help="page to write")
    return parser


if __name__ == "__main__":
    main()
