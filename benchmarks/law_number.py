"""What a number of the law is worth: fly a suite with other values of it, and compare draw by draw with the code as it is.

    python benchmarks/law_number.py runs/numbers evidence.SLOW_S 1.5 6 --draws 250 --seed 5
    python benchmarks/law_number.py runs/thrust jam_detection.ENGINE_S 4 --kind thrust

Numbers are those of the page *Numbers of the law*, by module and name. There is one folder of `testbed benchmark` for each value,
and one for the code as it is; an unfinished one is resumed. Not for seeds that results are reported of.

Few flights of `open` have any one kind of failure, and what is held hardly sees a flight that strays farther. So a number is also
flown with the kind of failure that it is for, and the worst errors are compared.
"""

from __future__ import annotations

import argparse
import ast
import difflib
import math
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pandas as pd
import yaml
from parts_where_they_act import KINDS, suite_of

from testbed.common.statistics import mean
from testbed.reporting.words import interval

ROOT = Path(__file__).parents[1]
LAW = Path("src") / "testbed" / "controllers"
WORST = {"altitude_error_max_m": "worst altitude error", "heading_error_max_deg": "worst heading error"}


def file_of(module: str) -> Path:
    """The module of the law with this name, below the root."""
    found = [LAW / folder / f"{module}.py" for folder in ("", "inversion")]
    for file in found:
        if (ROOT / file).is_file():
            return file
    raise SystemExit(f"no module {module!r} in {LAW} or {LAW / 'inversion'}")


def with_value(text: str, name: str, value: str) -> str:
    """The text of a module in which this number has another value."""
    try:
        ast.parse(value, mode="eval")
    except SyntaxError:
        raise SystemExit(f"{value!r} is no value, expected an expression such as 3.0") from None
    names = []
    for node in ast.parse(text).body:
        if not isinstance(node, ast.Assign):
            continue
        target, given = node.targets[0], node.value
        pairs = [(target, given)]
        if isinstance(target, ast.Tuple) and isinstance(given, ast.Tuple):
            pairs = list(zip(target.elts, given.elts, strict=True))
        names += [each.id for each, _ in pairs if isinstance(each, ast.Name)]
        for each, number in pairs:
            if isinstance(each, ast.Name) and each.id == name:
                lines = text.splitlines(keepends=True)
                line, end = number.lineno - 1, number.end_lineno or number.lineno
                before, after = lines[line][: number.col_offset], lines[end - 1][number.end_col_offset :]
                return "".join([*lines[:line], before + value + after, *lines[end:]])
    alike = "".join(f", did you mean {near}?" for near in difflib.get_close_matches(name, names, 1))
    raise SystemExit(f"this module has no number {name!r}{alike}")


def fly(folder: Path, options: argparse.Namespace, number: str = "", value: str = "") -> pd.DataFrame:
    """The results of the default on the suite, by draw, with another value of a number if one is given."""
    with tempfile.TemporaryDirectory() as place:
        tree = Path(place)
        shutil.copytree(ROOT / "src" / "testbed", tree / "src" / "testbed")
        for shared in ("aircraft", "scenarios"):
            (tree / shared).symlink_to(ROOT / shared)
        if number:
            module, _, name = number.partition(".")
            file = tree / file_of(module)
            file.write_text(with_value(file.read_text(encoding="utf-8"), name, value), encoding="utf-8")
        flags = [f"--seed={options.seed}", f"--draws={options.draws}", "--controller=default", "--no-plots"]
        command = [sys.executable, "-m", "testbed", "benchmark", options.suite, *flags, "--out", str(folder)]
        if folder.exists():
            command.append("--resume")
        environment = {**os.environ, "PYTHONPATH": str(tree / "src")}
        flown = subprocess.run(command, cwd=tree, env=environment, check=False, stdout=subprocess.DEVNULL)
        if flown.returncode:
            raise SystemExit(flown.returncode)  # it has said why
    return pd.read_csv(folder / "results.csv").set_index("draw")


def ratio_of_worst(before: pd.Series, after: pd.Series) -> str:
    """Geometric mean over the draws of how many times larger the worst error is, with its interval. What is less than 1 m or 1 deg
    hardly counts."""
    change = mean(np.log((1.0 + after) / (1.0 + before)).dropna().tolist()).plain
    return interval({key: math.exp(change[key]) for key in ("estimate", "low", "high")})


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path)
    parser.add_argument("number", help="module.NAME")
    parser.add_argument("value", nargs="+", help="each an expression, such as 3.0")
    flown = parser.add_mutually_exclusive_group()
    flown.add_argument("--suite", default="open", help="name or file of a suite")
    flown.add_argument("--kind", choices=KINDS, help="in place of it `open` with only one kind of failure")
    parser.add_argument("--draws", type=int, default=250)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(arguments)
    module, _, name = options.number.partition(".")
    for value in options.value:
        with_value((ROOT / file_of(module)).read_text(encoding="utf-8"), name, value)
    options.folder = options.folder.absolute()
    options.folder.mkdir(parents=True, exist_ok=True)
    if Path(options.suite).is_file():
        options.suite = str(Path(options.suite).absolute())  # each value is flown in a folder of its own
    if options.kind:
        options.suite = str(options.folder / f"{options.kind}.yaml")
        Path(options.suite).write_text(
            yaml.safe_dump(suite_of(options.kind), sort_keys=False), encoding="utf-8"
        )
    as_it_is = fly(options.folder / "as_it_is", options)
    for value in options.value:
        other = fly(options.folder / f"{options.number}={value}", options, options.number, value)
        changes = {key: (other[key].astype(float) - as_it_is[key]) for key in ("held", "inside", "survived")}
        words = [
            f"{key} {interval(mean(change.tolist()).plain, form='+.4f')}" for key, change in changes.items()
        ]
        words += [f"{name} times {ratio_of_worst(as_it_is[key], other[key])}" for key, name in WORST.items()]
        print(f"{options.number} = {value}: {', '.join(words)}", flush=True)


if __name__ == "__main__":
    main()
