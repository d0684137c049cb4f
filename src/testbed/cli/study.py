"""A sweep or a search that ends early, by an error or by Ctrl-C, keeps its flights and says how to go on."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from testbed.cli.status import ENDED_EARLY, INTERRUPTED, Ended
from testbed.cli.working import working


@contextmanager
def flying() -> Iterator[None]:
    """For the block that flies: raises Ended when it stops before the last flight."""
    from testbed.studies.run import Stopped

    try:
        yield
    except Stopped as stopped:
        by_user = isinstance(stopped.__context__, KeyboardInterrupt)
        raise Ended(str(stopped), INTERRUPTED if by_user else ENDED_EARLY) from None


@contextmanager
def writing(folder: Path, again: str) -> Iterator[None]:
    """For the block that writes what was found: raises Ended, with what writes the rest, when it cannot."""
    try:
        with working("drawing and writing"):
            yield
    except KeyboardInterrupt:
        raise Ended(f"{folder}: interrupted; every flight is kept; {again}", INTERRUPTED) from None
    except OSError as error:
        why = f"cannot write: {error.strerror or error}"
        raise Ended(f"{folder}: {why}; every flight is kept; {again}", ENDED_EARLY) from None
