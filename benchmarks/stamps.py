"""The stamp of a page of results: with what it was flown, and whether that is still the program of today.

A stamp is a comment at the end of a page, which `pages.py` writes. The site shows it in words at the top of the page
(`docs/generate/site_hooks.py`).
"""

from __future__ import annotations

import platform
import re
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass
from functools import cache
from importlib.metadata import version
from pathlib import Path

import yaml
from digests import ROOT, digest, proven

_STAMP = re.compile(r"\n*<!-- stamp\n(.*?)-->\n*\Z", flags=re.DOTALL)
NOT_RECORDED = "not recorded"


@dataclass(frozen=True)
class Stamp:
    """With what a page was flown.

    Attributes:
        commit: of the program, short; `with changes` follows if there were some that are in no commit.
        date: of the flights.
        seeds: in words.
        command: that flies the page again.
        environment: of the flights, in words.
        digests: of each part that the page depends on, by `digests.digest`.
    """

    commit: str
    date: str
    seeds: str
    command: str
    environment: str
    digests: Mapping[str, str]

    def changed(self) -> list[str]:
        """The parts that are not what they were, and not proven to fly the same."""
        return [part for part, before in self.digests.items() if not proven(part, before, _today(part))]

    def moved(self) -> list[str]:
        """The parts whose code has changed, whether or not it is proven to fly the same."""
        return [part for part, before in self.digests.items() if before != _today(part)]


def read(text: str) -> Stamp | None:
    """The stamp of a page's Markdown; None if it has none."""
    found = _STAMP.search(text)
    return Stamp(**yaml.safe_load(found.group(1))) if found else None


def stamped(text: str, stamp: Stamp) -> str:
    """The page with this stamp in place of any that it has."""
    fields = yaml.safe_dump(asdict(stamp), sort_keys=False, width=1000)
    return f"{_STAMP.sub('', text).rstrip()}\n\n<!-- stamp\n{fields}-->\n"


def shown(text: str) -> str:
    """A page's Markdown with its stamp in words below the title; as it is if it has none."""
    stamp = read(text)
    if stamp is None:
        return text
    title, _, rest = _STAMP.sub("\n", text).partition("\n")
    return f"{title}\n\n{words(stamp)}\n{rest}"


def words(stamp: Stamp) -> str:
    """The stamp as an admonition: a warning if a part of the program has changed since."""
    how = f"`{stamp.command}`; seeds: {stamp.seeds}; environment: {stamp.environment}."
    changed, moved = stamp.changed(), stamp.moved()
    if changed:
        kind, title = "warning", f"Older than the program: flown on {stamp.date}"
        since = f"Changed since {stamp.commit}: {', '.join(changed)}. A flight of today may differ."
    else:
        kind, title = "info", f"Flown on {stamp.date}"
        same = (
            "the code has changed, and flights of both are the same byte by byte (`benchmarks/same_bytes.py`)"
        )
        since = f"Since {stamp.commit} {same if moved else 'nothing that it depends on has changed'}."
    return f'!!! {kind} "{title}"\n    {since}\n    {how}\n'


def digests_of(parts: Iterable[str], root: Path = ROOT) -> dict[str, str]:
    """The digest of each part in the checkout at `root`."""
    return {part: digest(part, root) for part in parts}


def environment() -> str:
    """This environment, as far as the last digits of a flight may depend on it."""
    import numpy as np
    from threadpoolctl import threadpool_info

    packages = ", ".join(f"{name} {version(name)}" for name in ("numpy", "scipy", "numba", "jsbsim"))
    kernels = sorted({pool["architecture"] for pool in threadpool_info() if "architecture" in pool})
    found = np.show_config(mode="dicts")["SIMD Extensions"].get("found", [])  # type: ignore[call-overload]
    features = f"{platform.machine()}{f' with {found[-1]}' if found else ''}"
    return f"Python {platform.python_version()}, {packages}, {features}, BLAS kernel {'/'.join(kernels) or 'unknown'}"


@cache
def _today(part: str) -> str:
    return digest(part)
