"""How this process calculates, as far as the last digits of a flight depend on it: versions, and digests of what comes out.

Measured with `mems_turbulence.yaml`: another kernel of OpenBLAS and another set of functions in the C library change the bytes of
its log. Which ones are in use depends on the processor, on the libraries and on the environment (`OPENBLAS_CORETYPE`,
`GLIBC_TUNABLES`). So instead of a list of reasons there are digests of what comes out: of matrix products and decompositions of the
sizes that controllers use, and of the elementary functions.
"""

from __future__ import annotations

import hashlib
import importlib.metadata
import math
import platform
from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any

import numpy as np

_POINTS, _SIZES = 500, (2, 4, 8, 12, 24)
_SAID = {
    "matrices": ("kernel", "the BLAS kernel"),
    "functions": ("library", "the C library or the processor"),
}
"""Each digest, and what is said of it where it differs."""
_VERSIONS = ("testbed", "jsbsim", "numpy", "scipy", "numba")


def environment() -> dict[str, Any]:
    """All of it: `versions` {package: version}, and the `arithmetic`."""
    return {"versions": {name: _version(name) for name in _VERSIONS}, "arithmetic": dict(arithmetic())}


@cache
def arithmetic() -> Mapping[str, str]:
    """Digests of `matrices` and `functions`, and the names of what they come from: BLAS `kernel`, C `library`, `processor`."""
    from threadpoolctl import threadpool_info

    kernels = {pool["architecture"] for pool in threadpool_info() if "architecture" in pool}
    return {
        "matrices": _digest(_matrices()),
        "functions": _digest(_functions()),
        "kernel": " and ".join(sorted(kernels)) or "unknown",
        "library": " ".join(platform.libc_ver()).strip() or "unknown",
        "processor": platform.machine(),
    }


def differences(before: Mapping[str, Any], now: Mapping[str, Any]) -> Iterator[str]:
    """What of an `environment` is other than before, in words."""
    versions = before.get("versions", {})
    for name, version in now.get("versions", {}).items():
        if (old := versions.get(name)) != version:
            yield f"{name} {old or 'not installed'}, this is {version or 'not installed'}"
    yield from _other_digits(before.get("arithmetic", {}), now.get("arithmetic", {}))


def _other_digits(before: Mapping[str, Any], now: Mapping[str, str]) -> Iterator[str]:
    """What calculates otherwise; nothing where it was not recorded, as by earlier versions."""
    for digits, (source, what) in _SAID.items():
        if digits in before and digits in now and before[digits] != now[digits]:
            names = f"{before.get(source, 'unknown')}, this is {now.get(source, 'unknown')}"
            yield f"other last digits of {digits}, which depend on {what}: {names}"


def _version(name: str) -> str:
    """The version of a package on which the last digits of a flight may depend; "" where the repository is not installed."""
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return ""


def _digest(parts: Iterator[Any]) -> str:
    found = hashlib.sha256()
    for part in parts:
        found.update(np.ascontiguousarray(part, dtype=complex).tobytes())
    return found.hexdigest()[:16]


def _matrices() -> Iterator[Any]:
    from scipy import linalg

    draws = np.random.default_rng(0)
    for n in _SIZES:
        a, b = draws.normal(size=(2, n, n))
        yield a @ b
        yield a @ b[0]
        yield np.linalg.solve(a, b)
        yield np.linalg.pinv(a[: n // 2 + 1])
        yield np.linalg.eigvals(a)
        yield linalg.solve_continuous_are(a, b, np.eye(n), np.eye(n))


def _functions() -> Iterator[Any]:
    values = np.random.default_rng(1).uniform(0.01, 3.0, _POINTS)
    for one, all_ in ((math.sin, np.sin), (math.cos, np.cos), (math.tan, np.tan), (math.exp, np.exp), (math.log, np.log),
                      (math.atan, np.arctan), (math.tanh, np.tanh)):  # fmt: skip
        yield [one(value) for value in values.tolist()]
        yield all_(values)
    yield [math.pow(value, 0.37) for value in values.tolist()]
    yield [math.atan2(value, 1.1) for value in values.tolist()]
