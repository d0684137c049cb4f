"""Tables are the same when the columns of before are, byte by byte; columns that are new are named."""

from __future__ import annotations

import pytest
import same_bytes

LOG = b"time_s,p\n0,1.5\n1,nan\n"


@pytest.mark.parametrize(
    ("before", "after", "same", "said"),
    [
        (LOG, LOG, True, ""),
        (LOG, b"time_s,q,p\n0,7,1.5\n1,8,nan\n", True, "columns added: log.csv: q"),
        (LOG, b"time_s,q,p\n0,7,1.50\n1,8,nan\n", False, "differs: log.csv: p"),
        (LOG, b"time_s,q\n0,7\n1,8\n", False, "differs: log.csv: p"),
        (LOG, b"time_s,p\n0,1.5\n", False, "differs: log.csv: time_s, p"),
        (LOG, b"p,time_s\n1.5,0\nnan,1\n", False, "differs: log.csv"),
        (None, LOG, True, "only after: log.csv"),
    ],
)
def test_a_table(before: bytes | None, after: bytes, same: bool, said: str) -> None:
    assert same_bytes.compared("log.csv", before, after) == (same, said)


def test_a_missing_file_differs() -> None:
    assert same_bytes.compared("log.csv", LOG, None) == (False, "only before: log.csv")


def test_a_summary_is_the_same_or_differs() -> None:
    assert same_bytes.compared("summary.json", b"{}", b"{}") == (True, "")
    assert same_bytes.compared("summary.json", b"{}", b"{ }") == (False, "differs: summary.json")
