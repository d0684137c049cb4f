"""What changes the bytes of a flight changes the digests, and nothing else does."""

from __future__ import annotations

import json
import os
import platform
import subprocess
import sys

import pytest

from testbed.common.arithmetic import arithmetic, differences, environment

_CODE = "import json; from testbed.common.arithmetic import arithmetic; print(json.dumps(dict(arithmetic())))"
intel = pytest.mark.skipif(platform.machine() != "x86_64", reason="names of kernels of other processors")


def under(**environment: str) -> dict[str, str]:
    """The digests in a process with these variables."""
    done = subprocess.run(
        [sys.executable, "-c", _CODE], env={**os.environ, **environment}, capture_output=True, check=True
    )
    return json.loads(done.stdout)


@intel
def test_another_kernel_of_blas_is_noticed() -> None:
    one, other = under(OPENBLAS_CORETYPE="Haswell"), under(OPENBLAS_CORETYPE="Nehalem")
    assert one["matrices"] != other["matrices"] and one["functions"] == other["functions"]
    (words,) = differences({"arithmetic": one}, {"arithmetic": other})
    assert words.endswith("which depend on the BLAS kernel: Haswell, this is Nehalem")


@intel
def test_other_functions_of_the_c_library_are_noticed() -> None:
    fewer = under(GLIBC_TUNABLES="glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-AVX2,-FMA,-AVX512F")
    now = under()
    if fewer["functions"] == now["functions"]:
        pytest.skip("this C library or this processor has one set of functions alone")
    assert fewer["matrices"] == now["matrices"]
    (words,) = differences({"arithmetic": fewer}, {"arithmetic": now})
    assert "the C library or the processor" in words


def test_the_same_calculates_alike_however_many_threads_there_are() -> None:
    assert under(OPENBLAS_NUM_THREADS="1") == under(OPENBLAS_NUM_THREADS="2") == dict(arithmetic())


def test_arithmetic_that_was_not_recorded_is_no_difference() -> None:
    now = environment()
    assert list(differences({"versions": now["versions"]}, now)) == [] == list(differences(now, now))
    assert "numpy not installed, this is" in "".join(differences({"arithmetic": {}}, now))
