"""A number of the law with another value: the code's own text, with that number changed and nothing else."""

from __future__ import annotations

import law_number
import law_numbers
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
