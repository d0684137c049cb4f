"""The exit status of every command; docs/reference/command_line.md says the same to users."""

MET = 0
"""Every requirement was met, or the command has none."""
NOT_MET = 1
"""Flown, but a requirement was not met or the aircraft was lost."""
BAD_INPUT = 2
"""Bad input: nothing was flown or written."""
ENDED_EARLY = 3
"""The command could not be carried out to its end, as on a full disk; what a sweep has flown is kept."""
INTERRUPTED = 130
"""Ctrl-C, or SIGTERM or SIGHUP: 128 and the number of the signal SIGINT, as shells have it."""


class Ended(Exception):
    """A command could not be carried out to its end: what to say on stderr, and the exit status."""

    def __init__(self, words: str, status: int) -> None:
        super().__init__(words)
        self.status = status
