"""A number of the law with another value: the code's own text, with that number changed and nothing else."""

from __future__ import annotations

import law_number
import law_numbers
import pandas as pd
import pytest

TEXT = 'A = 1.0\n"""Alone."""\nB, C = 2.0, 3.0  # two\nD = np.linspace(\n    0.0,\n    1.0,\n)\nE = 5\n'


@pytest.mark.parametrize(
    ("name", "changed"),
    [
        ("A", ("A = 1.0", "A = 9.5")),
        ("B", ("2.0, 3.0", "9.5, 3.0")),
        ("C", ("2.0, 3.0", "2.0, 9.5")),
        ("E", ("E = 5", "E = 9.5")),
    ],
)
def test_one_number_is_changed(name: str, changed: tuple[str, str]) -> None:
    assert law_number.with_value(TEXT, name, "9.5") == TEXT.replace(*changed)


def test_a_number_of_several_lines() -> None:
    assert law_number.with_value(TEXT, "D", "0") == TEXT[: TEXT.index("np.linspace")] + "0\nE = 5\n"


def test_each_number_of_the_page_is_found() -> None:
    for number in law_numbers.numbers():
        module, name = number.where, number.said.partition(" =")[0].partition(",")[0]
        text = (law_number.ROOT / law_number.file_of(module)).read_text(encoding="utf-8")
        names = [each for each in (name, f"_{name}") if f"\n{each}" in text]
        assert law_number.with_value(text, names[0], "12345.0") != text


@pytest.mark.parametrize("wrong", ["loss_detection.NOTHING", "nowhere.SLOW_S"])
def test_what_is_no_number_of_the_law_is_said_before_anything_flies(wrong: str, tmp_path) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(SystemExit, match=r"NOTHING|nowhere"):
        law_number.main([str(tmp_path / "out"), wrong, "1.0"])
    assert not (tmp_path / "out").exists()


def test_a_suite_in_the_present_folder_is_found_from_every_other(tmp_path, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    suites = []

    def fly(folder, options, number="", value=""):  # type: ignore[no-untyped-def]
        suites.append(options.suite)
        return pd.DataFrame({key: [1.0, 2.0] for key in ("held", "inside", "survived", *law_number.WORST)})

    monkeypatch.setattr(law_number, "fly", fly)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.yaml").touch()
    law_number.main(["out", "evidence.SLOW_S", "1.0", "--suite", "mine.yaml"])
    law_number.main(["out", "evidence.SLOW_S", "1.0", "--kind", "thrust"])
    law_number.main(["out", "evidence.SLOW_S", "1.0"])
    assert suites[::2] == [str(tmp_path / "mine.yaml"), str(tmp_path / "out" / "thrust.yaml"), "open"]
