"""The command line, as `python -m testbed`."""

from __future__ import annotations

import atexit
import gc
import sys

TYPE_CHECKING = False  # as `typing` has it, without the time to import it: until Ctrl-C is handled, every millisecond counts
if TYPE_CHECKING:
    from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command, of `sys.argv` if none is given, and return its exit status."""
    from testbed.cli import interrupts, start_checks, status

    atexit.register(
        gc.freeze
    )  # at its end Python would go through all that numba has loaded once more, for half a second
    atexit.register(interrupts.end_undisturbed)
    interrupts.end_at_once()  # before everything else is imported, which takes most of a second
    if words := start_checks.too_little_memory():
        print(words, file=sys.stderr)
        return status.ENDED_EARLY
    if words := start_checks.wrong_setting():
        print(words, file=sys.stderr)
        return status.BAD_INPUT
    from testbed.cli.commands import main
    from testbed.cli.threads import end_despite_threads

    return end_despite_threads(main(arguments))


if __name__ == "__main__":
    sys.exit(main())
