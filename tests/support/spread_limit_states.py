"""Limit states that another process can import."""

from __future__ import annotations

import os

import numpy as np


def linear(u: np.ndarray) -> np.ndarray:
    """Fails beyond two standard deviations."""
    return np.asarray(2.0 - u[:, 0])


def ends(u: np.ndarray) -> np.ndarray:
    """Ends the process that computes it."""
    os._exit(7)
