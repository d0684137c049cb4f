"""The colours of figures and pages, each by its name, with the lines and markers of several of a kind.

Those of several are by Okabe and Ito, darkened where they are too pale for a line: colour-blind readers tell them apart.
"""

from __future__ import annotations

from typing import Any

PALETTE: dict[str, tuple[str, str]] = {
    "back": ("#ffffff", "#15171a"), "text": ("#1b1d21", "#e6e8eb"), "muted": ("#5c6470", "#9aa3ae"),
    "grid": ("#e4e7eb", "#2a2e34"), "edge": ("#d5d9df", "#363b43"), "soft": ("#f5f6f8", "#1d2024"),
    "accent": ("#0b62a8", "#62b0ee"), "hand": ("#0b62a8", "#62b0ee"),
    "met": ("#23753a", "#5fc27b"), "met-back": ("#eff7f1", "#17281c"),
    "missed": ("#b3261e", "#ff8a80"), "missed-back": ("#fdf0ef", "#321b1a"),
    "truth": ("#111111", "#f2f3f5"), "belief": ("#0072b2", "#56b4e9"), "command": ("#d55e00", "#ff9d4d"),
    "second": ("#009e73", "#35c79b"), "third": ("#7a4fa3", "#b896e0"),
    "band": ("rgb(35 117 58 / .10)", "rgb(95 194 123 / .13)"),
    "band-edge": ("rgb(35 117 58 / .45)", "rgb(95 194 123 / .5)"),
    "band-missed": ("rgb(179 38 30 / .16)", "rgb(255 138 128 / .20)"),
    "limit": ("#8a919c", "#7c8592"), "failure": ("#c22f25", "#ff7569"),
    "healthy": ("#7aa6c9", "#4f7fa6"), "unnoticed": ("#e0a100", "#c79000"), "flagged": ("#d55e00", "#d96a1c"),
    "recovered": ("#2e8b57", "#2f9460"), "lost": ("#7d1d17", "#a33029"),
    "whole": ("#6f9fc4", "#6ea6d3"), "body": ("#c3c8cf", "#7c848f"),
    "v0": ("#0072b2", "#56b4e9"), "v1": ("#d55e00", "#ff9d4d"), "v2": ("#009e73", "#35c79b"),
    "v3": ("#b0578f", "#e09cc3"), "v4": ("#a87600", "#e6b84d"), "v5": ("#3a8fbf", "#8fd0f5"),
}  # fmt: skip
"""{name: (on white, on a dark page)}. Figures are on white."""
COLOURS = tuple(PALETTE[f"v{i}"][0] for i in range(6))
LINES = ("-", "--", ":", "-.", (0, (5, 1)), (0, (1, 1)))
MARKERS = "os^Dvp"
MISSED, MET = PALETTE["missed"][0], PALETTE["met"][0]


def css() -> str:
    """The palette as custom properties of a page: --back, --text and so on, light or as the reader's screen asks."""
    light, dark = ("".join(f"--{name}:{both[k]};" for name, both in PALETTE.items()) for k in range(2))
    return f":root{{color-scheme:light dark;{light}}}\n@media (prefers-color-scheme: dark){{:root{{{dark}}}}}"


def nth(i: int, *parts: str) -> dict[str, Any]:
    """The look of the i-th of several: its colour, and its `marker` and `ls` (line) if these are asked for."""
    looks: dict[str, Any] = {"marker": MARKERS[i % 6], "ls": LINES[i % 6]}
    return {"color": COLOURS[i % 6], **{part: looks[part] for part in parts}}
