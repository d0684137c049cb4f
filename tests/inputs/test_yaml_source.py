"""What YAML would misread is refused with its line, and what is written reads back."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from testbed.inputs.problems import BadInput
from testbed.inputs.yaml_source import as_yaml_float, describe, dump, parse, read

REFUSED = [
    ("a: 1\nb: 1e-3\n", 2, "b", "write 1.0e-3"),
    ("a: 1.5e3\n", 1, "a", "write 1.5e+3"),
    ("a: [1, 2e5]\n", 1, "a.1", "write 2.0e+5"),
    ("a:\n  b: .nan\n", 2, "a.b", "not a finite number"),
    ("a: nan\n", 1, "a", "not a finite number"),
    ("a: -.inf\n", 1, "a", "not a finite number"),
    ("a: 1.0e+999\n", 1, "a", "not a finite number"),
    ("a: 1:30\n", 1, "a", "base-60"),
    ("a: 0100\n", 1, "a", "octal"),
    ("a: 1\nb: 2\na: 3\n", 3, "a", "duplicate key, first written at line 1"),
    ("x:\n  - {a: 1, a: 2}\n", 2, "x.0.a", "duplicate key"),
    ("a: &x {b: 1}\nc: {<<: *x}\n", 2, "c.<<", "merging"),
    ("? [1, 2]\n: 3\n", 1, "", "not text"),
    ("a: 2020-13-45\n", 1, "a", "cannot be read"),
    ("a: !!python/object:os.system x\n", 1, "a", "cannot be read"),
    ("a: !!bool x\n", 1, "a", "'x' cannot be read: no bool"),
    ("a: !!int ''\n", 1, "a", "'' cannot be read: no int"),
    ("a: !!float ''\n", 1, "a", "cannot be read: no float"),
    ("a: !!timestamp x\n", 1, "a", "cannot be read: no timestamp"),
    (f"a: {10**400}\n", 1, "a", "too large a number"),
    (f"a: 0x{'f' * 5000}\n", 1, "a", "too large a number"),
    (f"a: 1{':59' * 3000}\n", 1, "a", "too large a number"),
]


@pytest.mark.parametrize(("text", "line", "path", "what"), REFUSED)
def test_refused_at_its_place(text: str, line: int, path: str, what: str) -> None:
    (problem,) = parse(text, "f.yaml").problems
    assert (problem.file, problem.line, problem.path) == ("f.yaml", line, path)
    assert what in problem.what


@pytest.mark.parametrize(
    "text", ["a: 1.0e-3\n", "a: '1e-3'\n", 'a: "nan"\n', "a: b\nc: b\n", "a: 0\n", "a: 10:30 late"]
)
def test_accepted(text: str) -> None:
    """The negative control: near misses of what is refused."""
    assert parse(text).problems == []


@pytest.mark.parametrize(
    ("text", "line", "what"),
    [
        ("a: 1\n\tb: 2\n", 2, "tab"),
        ("a: 1\nb: [1, 2\n", 3, "not YAML"),
        ("a: 1\nb: : 2\n", 2, "not YAML"),
        ("a: 1\n--- \nb: 2\n", 2, "not YAML"),
        ("a: *missing\n", 1, "not YAML"),
        ("a: \x07\n", 1, "not YAML"),
        ("a: &a [*a]\n", 1, "contains itself"),
        ("[" * 5000, None, "nested too deeply"),
        (
            "a0: &a0 x\n" + "".join(f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 9)}]\n" for i in range(1, 9)),
            None,
            "more than",
        ),
    ],
)
def test_not_yaml(text: str, line: int | None, what: str) -> None:
    with pytest.raises(BadInput) as caught:
        parse(text, "f.yaml")
    (problem,) = caught.value.problems
    assert what in problem.what
    assert line is None or abs((problem.line or 0) - line) <= 1
    assert line is None or problem.line


@pytest.mark.parametrize("content", [b"", b"- 1\n", b"text", b"\xff\xfe\x00x"])
def test_unusable_files(tmp_path: Path, content: bytes) -> None:
    file = tmp_path / "x.yaml"
    file.write_bytes(content)
    with pytest.raises(BadInput, match=r"x\.yaml"):
        read(file)


def test_no_file_and_folder(tmp_path: Path) -> None:
    with pytest.raises(BadInput, match="no such file"):
        read(tmp_path / "nothing.yaml")
    with pytest.raises(BadInput, match="folder"):
        read(tmp_path)


def test_a_file_without_line_breaks_at_its_end_or_with_windows_ones() -> None:
    assert parse("a: 1\r\nb: 1e-3").problems[0].line == 2


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_the_suggested_spelling_is_read_as_the_same_number(value: float) -> None:
    for text in (f"{value:e}", repr(value), f"{value:g}"):
        source = parse(f"a: {as_yaml_float(text)}")
        assert source.problems == []
        assert source.tree == {"a": float(text)}


texts = st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\0"))
leaves = st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False) | texts
trees = st.recursive(leaves, lambda inner: st.lists(inner) | st.dictionaries(texts, inner), max_leaves=20)


@pytest.mark.nightly
@given(st.dictionaries(texts, trees))
def test_what_is_dumped_is_read_back(tree: dict[str, object]) -> None:
    source = parse(dump(tree))
    assert source.problems == []
    assert source.tree == tree


@given(st.text())
def test_any_text_is_read_or_refused(text: str) -> None:
    try:
        parse(text)
    except BadInput as error:
        assert error.problems


def test_places_are_of_the_key_or_the_nearest_thing_around() -> None:
    source = parse("a:\n  b: 1\n  c:\n    - 2\n    - {d: 3}\n", "f.yaml")
    assert source.place(("a", "c", 1, "d")) == ("f.yaml", 5)
    assert source.place(("a", "c")) == ("f.yaml", 3)
    assert source.place(("a", "x", "y")) == ("f.yaml", 1)
    assert source.problem(("a", "c", 0), "is 2", "3").line == 4


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (None, "empty"),
        ({}, "a mapping"),
        ([1], "a list"),
        ((1,), "a list"),
        (True, "true"),
        (1.5, "1.5"),
        ("a", "'a'"),
    ],
)
def test_describe(value: object, text: str) -> None:
    assert describe(value) == text


def test_a_long_value_is_cut() -> None:
    assert len(describe("x" * 1000)) == 60


def test_text_that_no_file_can_hold_is_refused() -> None:
    source = parse('a: "x\\0"\nb: ["\\ud800"]\n"c\\0": 1\n', "f.yaml")
    assert [(p.line, p.path) for p in source.problems] == [(1, "a"), (2, "b.0"), (3, "")]
    assert all("a NUL character or half a surrogate pair" in p.what for p in source.problems)


@pytest.mark.nightly
def test_reading_stops_at_too_many_values() -> None:
    with pytest.raises(BadInput, match=r"f\.yaml:2: has more than 100000 values"):
        parse("a:\n [" + "{a: 1}," * 40_000 + "]", "f.yaml")
