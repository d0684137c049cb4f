"""What is run from a folder of one's own can have been put there by nobody else. Attacks are made by a second user."""

from __future__ import annotations

import os
import stat
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest

from testbed.common import jit
from testbed.common.private import cache_home, is_private
from testbed.plant import first_load
from testbed.studies.benchmark.load import hangar

VICTIM, OTHER = 4_000_001, 4_000_002
"""Numbers of two users that the machine does not know."""


def by(user: int, act: Callable[[], object]) -> str:
    """What a function returns, as text, in a process of another user."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.setgroups([])
            os.setgid(user)
            os.setuid(user)
            os.umask(0o022)
            os.write(write, str(act()).encode())
        except BaseException as error:
            os.write(write, repr(error).encode())
        finally:
            os._exit(0)
    os.close(write)
    with os.fdopen(read) as stream:
        found = stream.read()
    os.waitpid(child, 0)
    return found


def _others_read_the_package() -> bool:
    """Whether another user can reach the package's files: not in a checkout below a private folder."""
    return os.getuid() == 0 and by(VICTIM, lambda: os.listdir(Path(jit.__file__).parent)).startswith("[")


as_root = pytest.mark.skipif(
    not _others_read_the_package(),
    reason="acts as two users, which only root can, where others can read the package",
)


@pytest.fixture
def shared(monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder as /tmp is, which all users may write into; there is no home folder."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o1777)
        monkeypatch.setattr(tempfile, "tempdir", folder)
        monkeypatch.setenv("HOME", "")
        monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
        yield Path(folder)  # type: ignore[misc]


def _opened(folder: Path) -> None:
    """A folder into which the victim's process can write, as into one of its own."""
    folder.mkdir()
    folder.chmod(0o777)


def _linked(folder: Path) -> None:
    _opened(folder.with_name("planted"))
    folder.symlink_to(folder.with_name("planted"))


def _file(folder: Path) -> None:
    folder.write_text("")


@as_root
@pytest.mark.parametrize("plant", [_opened, _linked, _file], ids=["folder", "link", "file"])
def test_compiled_code_is_kept_where_no_other_user_can_write(
    plant: Callable[[Path], None], shared: Path
) -> None:
    usual = shared / f"testbed-{VICTIM}"
    by(OTHER, lambda: plant(usual))
    before = sorted(shared.rglob("*"))
    kept = Path(by(VICTIM, jit._cache_folder))
    assert kept.is_relative_to(shared) and not kept.is_relative_to(usual)
    for folder in (kept, kept.parent):
        assert (folder.stat().st_uid, stat.S_IMODE(folder.stat().st_mode)) == (VICTIM, 0o700)
    assert set(shared.rglob("*")) - set(before) == {kept, kept.parent}, "nothing in what the other has made"
    assert by(VICTIM, jit._cache_folder) == str(kept), "the next process finds the code"


@as_root
def test_adopted_aircraft_are_those_of_this_user(shared: Path) -> None:
    """Another user has put aircraft where a benchmark would look without a home folder."""
    name = hangar.__wrapped__().name  # what it finds here is not to be kept
    for root in (shared / "testbed", shared / f"testbed-{VICTIM}"):
        by(OTHER, lambda root=root: (root / name / "c172p").mkdir(parents=True))  # type: ignore[misc]
    kept = Path(by(VICTIM, hangar.__wrapped__))
    assert kept.name == name and kept.stat().st_uid == VICTIM and not list(kept.iterdir())


@as_root
def test_without_a_private_place_no_aircraft_is_adopted(shared: Path) -> None:
    shared.chmod(0o777)  # without the sticky bit
    assert "no place for adopted aircraft" in by(VICTIM, hangar.__wrapped__)


@as_root
def test_the_usual_folder_is_kept_where_nobody_has_taken_it(shared: Path) -> None:
    assert Path(by(VICTIM, jit._cache_folder)).parent == shared / f"testbed-{VICTIM}"


@as_root
def test_no_code_is_kept_where_others_could_move_the_folder(shared: Path) -> None:
    shared.chmod(0o777)  # without the sticky bit
    assert by(VICTIM, jit._cache_folder) == "None"
    assert [path for path in shared.iterdir() if "cache" in path.name] == []


@as_root
def test_a_folder_for_compiled_code_that_was_chosen_must_be_private_too(shared: Path) -> None:
    by(OTHER, lambda: _opened(shared / "chosen"))
    assert by(VICTIM, lambda: jit._chosen_folder(shared / "chosen")) == "None"
    assert by(VICTIM, lambda: jit._chosen_folder(shared / "own")) == str(shared / "own")


@as_root
def test_records_of_aircraft_are_believed_from_private_folders_alone(
    shared: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(shared / "caches"))
    by(VICTIM, lambda: first_load.write_record("digest", {"properties": {}}))
    assert by(VICTIM, lambda: first_load.read_record("digest")) == "{'properties': {}}"
    (shared / "caches").chmod(0o777)
    assert by(VICTIM, lambda: first_load.read_record("digest")) == "None"


@pytest.mark.parametrize(
    ("mode", "private"), [(0o700, True), (0o755, True), (0o757, False), (0o1777, False)], ids=oct
)
def test_others_may_not_write_into_the_folder(mode: int, private: bool, tmp_path: Path) -> None:
    tmp_path.chmod(mode)
    assert is_private(tmp_path) == private
    below = tmp_path / "below"
    below.mkdir(mode=0o700)
    assert is_private(below) == (private or mode == 0o1777), "in a folder with the sticky bit, one's own are"


def test_what_is_no_folder_is_not_private(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    (tmp_path / "link").symlink_to(tmp_path)
    for name in ("file", "link", "missing", "link/file"):
        assert not is_private(tmp_path / name)


@pytest.mark.parametrize(
    ("chosen", "home", "expected"),
    [
        ("/caches", "/home/me", "/caches"),
        ("", "/home/me", "/home/me/.cache"),
        (None, "/home/me", "/home/me/.cache"),
        ("caches", "/home/me", "/home/me/.cache"),
        ("caches", "", None),
        (None, "me", None),
    ],
)
def test_caches_are_neither_in_the_working_folder_nor_in_the_root_folder(
    chosen: str | None, home: str, expected: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    if chosen is not None:
        monkeypatch.setenv("XDG_CACHE_HOME", chosen)
    monkeypatch.setenv("HOME", home)
    assert cache_home() == (None if expected is None else Path(expected))
