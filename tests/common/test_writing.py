"""Nothing that is there is written through, and nothing else than `writing` writes."""

from __future__ import annotations

import ast
import os
import shutil
import stat
import threading
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path

import pytest

import testbed
from testbed.common.writing import refuse_unsafe, replacing, write, write_new

SOURCES = Path(testbed.__file__).parent
WRITERS = {"write_text", "write_bytes", "touch", "savefig", "to_csv", "to_parquet", "to_json", "to_excel", "tofile", "save",
           "savez", "savetxt", "memmap", "mkstemp", "NamedTemporaryFile", "copyfile", "copytree",
           "symlink", "symlink_to", "hardlink_to", "connect", "FileIO", "FileHandler", "OSFile"}  # fmt: skip
"""Functions that write to a path, or that make a path lead elsewhere."""
SAVED = {
    ("cli/identify.py", "save"): "a method of the design model, which goes through `writing`",
    ("logs/entry.py", "save"): "a method of the design model, which goes through `writing`",
    ("cli/terminal.py", "open"): "the null device",
    ("cli/live.py", "open"): "a browser",
    ("pytest_plugin.py", "save"): "a method of a flight, which goes through `writing`",
    ("env/flight.py", "save"): "a method of a flight, which goes through `writing`",
    ("studies/flying/worker.py", "open"): "the null device",
    ("common/jit.py", "open"): "a lock in a private folder",
    ("controllers/external/process.py", "open"): "a file that `write_new` made, for a process to write to",
    ("controllers/external/ardupilot.py", "connect"): "a socket",
    ("inputs/bucket.py", "open"): "a file of a bucket, for reading",
    ("adoption/adopt.py", "save"): "a method of the design model, which goes through `writing`",
    ("reporting/figures/__init__.py", "save"): "goes through `writing`",
    ("reporting/figures/sheet.py", "save"): "into memory",
    ("study_reports/drawing.py", "save"): "goes through `writing`",
    ("studies/folder/store.py", "connect"): "SQLite, after `refuse_unsafe`",
    ("studies/folder/store.py", "copyfile"): "into a temporary folder of its own",
}
"""(file, function) of what looks like writing, and why it is none, or safe."""


@pytest.fixture
def victim(tmp_path: Path) -> Path:
    """A file outside the folder that is written into."""
    file = tmp_path / "victim"
    file.write_text("mine")
    return file


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The folder that is written into."""
    (tmp_path / "received").mkdir()
    return tmp_path / "received"


TRAPS: dict[str, Callable[[Path, Path], object]] = {
    "link": lambda file, victim: file.symlink_to(victim),
    "hard link": lambda file, victim: file.hardlink_to(victim),
    "dangling link": lambda file, victim: file.symlink_to(victim.with_name("new")),
    "pipe": lambda file, _: os.mkfifo(file),
    "linked name of before": lambda file, victim: file.with_name(f".{file.name}.partial").symlink_to(victim),
}
"""What a received folder may have in the place of a file."""


@pytest.mark.parametrize("trap", TRAPS)
def test_what_is_there_is_replaced_and_never_written_through(trap: str, folder: Path, victim: Path) -> None:
    file = folder / "report.html"
    TRAPS[trap](file, victim)
    write(file, "ours")
    assert (victim.read_text(), file.read_text()) == ("mine", "ours")
    assert stat.S_ISREG(os.lstat(file).st_mode) and os.lstat(file).st_nlink == 1
    assert not victim.with_name("new").exists()


@pytest.mark.parametrize("trap", TRAPS)
def test_a_new_file_is_made_nowhere_else(trap: str, folder: Path, victim: Path) -> None:
    file = folder / "log.csv"
    TRAPS[trap](file, victim)
    if os.path.lexists(file):
        with pytest.raises(FileExistsError):
            write_new(file, "ours")
    assert victim.read_text() == "mine" and not victim.with_name("new").exists()


@pytest.mark.parametrize("place", ["figures/states.png", "a/figures/states.png", "../outside/states.png"])
def test_folders_inside_are_entered_but_not_if_they_lead_outside(place: str, folder: Path) -> None:
    outside = folder.with_name("outside")
    (outside / "figures").mkdir(parents=True)
    (folder / "figures").symlink_to(outside)
    (folder / "a").symlink_to(outside)
    with pytest.raises(OSError):
        write(folder / place, b"", within=folder)
    assert [file for file in outside.rglob("*") if not file.is_dir()] == []
    write(folder / "new/figures/states.png", b"", within=folder)
    assert (folder / "new/figures/states.png").is_file()


def test_the_folder_that_was_asked_for_may_be_a_link(folder: Path, tmp_path: Path) -> None:
    (tmp_path / "usual").symlink_to(folder)
    write(tmp_path / "usual/figures/states.png", b"ours", within=tmp_path / "usual")
    assert (folder / "figures/states.png").read_bytes() == b"ours"


def test_nothing_is_written_outside_while_links_come_and_go(folder: Path, tmp_path: Path) -> None:
    """Somebody who may write into the folder swaps its subfolder with a link, as fast as they can."""
    outside, inside, away = tmp_path / "outside", folder / "figures", folder / "away"
    outside.mkdir()
    done = threading.Event()

    def swap() -> None:
        while not done.is_set():
            with suppress(OSError):
                inside.rename(away)
            with suppress(OSError):
                inside.symlink_to(outside)
                inside.unlink()
            shutil.rmtree(away, ignore_errors=True)

    swapping = threading.Thread(target=swap)
    swapping.start()
    refused = written = 0
    try:
        while (refused < 5 or written < 5) and refused + written < 20_000:
            try:
                write(inside / "states.png", b"ours", within=folder)
                written += 1
            except OSError:
                refused += 1
    finally:
        done.set()
        swapping.join()
    assert refused and written and list(outside.iterdir()) == []


def test_after_an_error_the_old_file_is_there_and_nothing_else(folder: Path) -> None:
    file = folder / "a.txt"
    write(file, "old")
    with pytest.raises(RuntimeError), replacing(file) as stream:
        stream.write(b"ne")
        raise RuntimeError
    assert file.read_text() == "old" and list(folder.iterdir()) == [file]


def test_a_reader_meanwhile_sees_the_old_contents(folder: Path) -> None:
    file = folder / "a.txt"
    write(file, "old")
    with replacing(file) as stream:
        stream.write(b"new")
        assert file.read_text() == "old"
    assert file.read_text() == "new" and list(folder.iterdir()) == [file]


def test_an_error_names_the_file_that_was_asked_for(folder: Path) -> None:
    (folder / "file").mkdir()
    with pytest.raises(OSError, match="directory") as caught:
        write(folder / "file", b"")
    assert caught.value.filename == str(folder / "file")
    assert [path.name for path in folder.iterdir()] == ["file"]


@pytest.mark.parametrize("trap", ["link", "hard link", "dangling link", "pipe"])
def test_a_database_in_a_received_folder_is_a_file_of_one_name(trap: str, folder: Path, victim: Path) -> None:
    file = folder / "flights.sqlite"
    refuse_unsafe(file)
    TRAPS[trap](file, victim)
    with pytest.raises(PermissionError, match="is a link or a device, or has other names"):
        refuse_unsafe(file)
    file.unlink()
    file.write_bytes(b"")
    refuse_unsafe(file)


def test_no_other_module_writes_to_a_path() -> None:
    found = {
        (str(file.relative_to(SOURCES)), name)
        for file in SOURCES.rglob("*.py")
        if file != SOURCES / "common/writing.py"
        and not {"template", "data"} & set(file.relative_to(SOURCES).parts)
        for name in writes(ast.parse(file.read_text(encoding="utf-8")))
    }
    assert found == set(SAVED)


@pytest.mark.parametrize(
    ("code", "found"),
    [
        ("open(file, 'w')", ["open"]),
        ("open(file, mode='ab')", ["open"]),
        ("open(file, how)", ["open"]),
        ("file.open('x')", ["open"]),
        ("os.open(file, os.O_CREAT | os.O_WRONLY)", ["open"]),
        ("file.write_text('')", ["write_text"]),
        ("frame.to_csv(file)", ["to_csv"]),
        ("sqlite3.connect(file)", ["connect"]),
        ("sqlite3.connect(':memory:')", []),
        ("open(file)", []),
        ("file.open(encoding='utf-8')", []),
        ("open(file, 'rb')", []),
        ("os.open(file, os.O_RDONLY | os.O_NONBLOCK)", []),
        ("shutil.copy(one, other)", ["copy"]),
        ("copy.copy(one)", []),
    ],
)
def test_the_test_finds_what_writes(code: str, found: list[str]) -> None:
    assert list(writes(ast.parse(code))) == found


def writes(tree: ast.AST) -> Iterator[str]:
    """The names of functions called in a module that open a path for writing."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        function = node.func
        name = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
        if (name == "open" and not _reads(node)) or (
            (name in WRITERS or ast.unparse(function) in ("shutil.copy", "shutil.copy2", "os.link"))
            and node.args
            and ast.unparse(node.args[0]) != "':memory:'"
        ):
            yield name


def _reads(call: ast.Call) -> bool:
    """Whether an `open` says in its own words that it reads: `open(file)`, `file.open("rb")`, `os.open(file, os.O_RDONLY)`."""
    is_method = isinstance(call.func, ast.Attribute) and ast.unparse(call.func.value) != "os"
    place = 0 if is_method else 1
    modes = [key.value for key in call.keywords if key.arg == "mode"] + call.args[place : place + 1]
    flags = "" if not modes else ast.unparse(modes[0])
    if ast.unparse(call.func) == "os.open":
        return set(flags.split(" | ")) <= {"os.O_RDONLY", "os.O_NONBLOCK", "os.O_DIRECTORY", "os.O_NOFOLLOW"}
    return flags in ("", "'r'", "'rb'")
