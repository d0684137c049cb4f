"""A user's class out of a file of theirs: its name, its place, and files that cannot be read."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest

from testbed.controllers.user.loader import load_controller, name_of, place_of, raised
from testbed.inputs.problems import BadInput


def written(folder: Path, text: str) -> str:
    (folder / "own.py").write_text(text)
    return f"{folder / 'own.py'}:Own"


def test_a_class_is_named_by_its_file(tmp_path: Path) -> None:
    own = load_controller(written(tmp_path, "class Own:\n    pass\n"))
    assert name_of(own) == "own:Own"
    assert place_of(own) == str(tmp_path / "own.py")
    assert name_of(Path) == f"{Path.__module__}:Path" and place_of(Path) == name_of(Path)


def test_files_beside_it_can_be_imported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "path", list(sys.path))
    (tmp_path / "gains_of_mine.py").write_text("KP = 3.0\n")
    own = load_controller(written(tmp_path, "from gains_of_mine import KP\nclass Own:\n    kp = KP\n"))
    assert own.kp == 3.0  # type: ignore[attr-defined]


def test_a_file_does_not_become_the_module_of_its_name(tmp_path: Path) -> None:
    (tmp_path / "json.py").write_text("class Own:\n    pass\n")
    load_controller(f"{tmp_path / 'json.py'}:Own")
    import json

    assert json.loads("[1]") == [1]


def test_an_exception_is_placed_at_the_users_last_line(tmp_path: Path) -> None:
    own = load_controller(written(tmp_path, "class Own:\n    def f(self):\n        return [].index(3)\n"))
    try:
        own().f()  # type: ignore[call-arg]
    except ValueError as error:
        problem = raised(error, str(tmp_path / "own.py"), "at 1 s")
    assert (problem.file, problem.line) == (str(tmp_path / "own.py"), 3)
    assert problem.what.startswith("raised at 1 s: ValueError")


def test_a_mistyped_class_is_guessed(tmp_path: Path) -> None:
    place = written(tmp_path, "class Owm:\n    pass\n")
    with pytest.raises(BadInput, match=r"has no class Own.*did you mean Owm\?"):
        load_controller(place)


@pytest.mark.parametrize(
    ("reference", "said"),
    [
        ("my_controller:MyController", "expected FILE.py:CLASS"),
        ("my_controller.py", "expected FILE.py:CLASS"),
        ("own.pi.py:Own", "own.pi.py: there is no such file, did you mean own.py?"),
    ],
)
def test_a_wrong_reference_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, reference: str, said: str
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("own.py").write_text("class Own: pass\n")
    with pytest.raises(BadInput, match=re.escape(said)):
        load_controller(reference)
