"""Loops of (13) in a flight whose forces are held, for `trimmed_law`: plain Python that numba compiles."""
# mypy: allow-untyped-defs

from __future__ import annotations

from testbed.common.jit import compiled
from testbed.controllers.inversion.law import lag_gain, low_pass


@compiled
def filter_error(e, lags, a):
    """The two lags of the regression on each row of e [steps, 4], in place."""
    gain = lag_gain(a)
    for k in range(len(e)):
        low_pass(e[k], lags, gain)


@compiled
def follow_newton(x, transition, out):
    """out[k] = transition out[k-1] + x[k], from zero; all [steps, n], transition [n, n]."""
    for k in range(len(x)):
        for i in range(x.shape[1]):
            out[k, i] = x[k, i]
            if k > 0:
                for j in range(x.shape[1]):
                    out[k, i] += transition[i, j] * out[k - 1, j]
