"""What the README says is so: short, its links lead somewhere, its commands and its Python run as written."""

from __future__ import annotations

import re
import shlex
import shutil
from pathlib import Path

import pytest
import readme
from blocks import block
from code_blocks import blocks
from command_line import ROOT, testbed

README = (ROOT / "README.md").read_text(encoding="utf-8")
COMMANDS = re.findall(r"^\| ([a-z ]+) \| `testbed (.+)` \|$", README, flags=re.MULTILINE)
STATUS = {
    "a flight": 1,
    "a sweep": 1,
    "the smallest failure that breaks it": 1,
    "gains from the noise of sensors and air": 0,
    "how wrong the input matrix may be": 0,
    "your own controller": 1,
    "your own aircraft": 0,
}
"""Exit status of each: another failure than the requirements are about, a sweep with lost flights, no estimates."""


def test_is_short() -> None:
    assert len(README.split()) < 900


@pytest.mark.parametrize("file", ["README.md", "CONTRIBUTING.md"])
def test_links_lead_somewhere(file: str) -> None:
    text = (ROOT / file).read_text(encoding="utf-8")
    links = [link for link in re.findall(r"\]\(([^)#]+)", text) if "://" not in link]
    assert links
    assert not [link for link in links if not (ROOT / link).exists()]


def test_the_lines_that_are_run_from_scratch_are_marked() -> None:
    """.ci/run takes them from here."""
    for marker in ("installs and flies", "installs and tests"):
        assert re.search(rf"<!-- {marker} -->\n```bash\npython3 -m venv [^\n]+\n```", README)


@pytest.mark.nightly
@pytest.mark.parametrize(("what", "command"), COMMANDS, ids=[what for what, _ in COMMANDS])
def test_its_commands_run(what: str, command: str, tmp_path: Path) -> None:
    """As written, in a folder with the checkout's examples and an aircraft of one's own."""
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    mine = shutil.copytree(ROOT / "aircraft" / "vtail", tmp_path / "my_aircraft")
    for kind in ("xml", "yaml"):
        (mine / f"vtail.{kind}").rename(mine / f"my_aircraft.{kind}")
    description = mine / "my_aircraft.yaml"
    description.write_text(description.read_text().replace("model: vtail", "model: my_aircraft"))
    ran = testbed(tmp_path, *shlex.split(command))
    assert ran.returncode == STATUS[what], ran.stdout + ran.stderr
    if shlex.split(command)[0] in ("design", "certify"):  # their answer is what they print
        assert not (tmp_path / "runs").exists() and ran.stdout
        return
    (folder,) = (tmp_path / "runs").iterdir()
    assert (folder / "report.html").is_file()


def test_its_python_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (block,) = blocks(README, "python")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "agg")
    names: dict[str, object] = {}
    exec(block, names)
    assert names["flight"].passed  # type: ignore[attr-defined]


def test_its_table_of_controllers_is_that_of_the_page() -> None:
    said, page = block(README, "benchmark"), readme.BENCHMARK.read_text(encoding="utf-8")
    assert said == readme.table(page)
    flown = [name for name in readme.WORDS if f"\n| `{name}` |" in page or f"\n| {name} |" in page]
    assert len(flown) > 5 and said.count("\n") == len(flown) + 1


SAID = {
    "benchmark": (
        r"(?s)\[(\d+ of \d+ draws)\].* Of \[(\d+)\]\S+ the default holds (\S+), "
        r"`indi` with that diagnosis (\S+): (\S+ \(\S+ to \S+\))\.",
        r"(?s)## The nearest(?=.*? alone holds (\d+ of \d+ draws))"
        r".*?Of (\d+) draws `default` holds (\S+) .*?`indi_monitor`, holds (\S+): (\S+ \(\S+ to \S+\))\.",
    ),
    "smallest_failures": (
        r"`indi` breaks later\]\S+ at (\d+) of (\d+) types of failure, the default at (\d+)\.",
        r"Breaks last alone: `default` at (?=\d+, `indi` at (\d+) of (\d+) types)(\d+)",
    ),
    "adoption": (r"\[(\d+) of 48 fixed-wing models\]", r"(\d+) of the 48 fixed-wing models"),
    "gallery": (
        r"Of (\d+) lost ailerons .*\[(\d+) are held\]\S+ and (\d+) survived; "
        r"of (\d+) lost elevators (\d+) held, (\d+) survived; of (\d+) healthy flights (\d+) held, (\d+) survived",
        ".*".join(
            rf"(?s:.*?)\| {lost} \| {air} \| default \| \d+ \| (\d+) \| (\d+) .*?\| (\d+) \("
            for lost, air in (("aileron", "turbulent"), ("elevator", "turbulent"), ("nothing", "turbulent"))
        ),
    ),
}
"""Numbers of pages that the README says: how it says them, and how the page does."""


@pytest.mark.parametrize("page", SAID)
def test_its_numbers_are_those_of_the_pages(page: str) -> None:
    text = (ROOT / "docs" / "results" / f"{page}.md").read_text(encoding="utf-8")
    here, there = (re.search(pattern, each) for pattern, each in zip(SAID[page], (README, text), strict=True))
    assert here and there and here.groups() == there.groups()


def test_its_picture_shows_what_a_flight_of_today_does() -> None:
    """The first seed: the default holds, and INDI and PID lose the aircraft."""
    first = range(readme.SEEDS.start, readme.SEEDS.start + 1)
    held = {
        name: readme.flown(readme.RIVALS.get(name, readme.DEFAULT), first) for name in ("", "indi", "pid")
    }
    assert [(tally.held, tally.survived) for tally in held.values()] == [(1, 1), (0, 0), (0, 0)]


@pytest.mark.nightly
def test_its_sentences_are_those_of_flights_of_today() -> None:
    default = readme.flown(readme.DEFAULT)
    rivals = {name: readme.at_its_best(controller) for name, controller in readme.RIVALS.items()}
    assert block(README, "picture") == readme.sentences(default, rivals)
    assert readme.sentences(rivals["indi"], rivals) != readme.sentences(default, rivals)  # negative control
