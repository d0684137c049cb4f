"""Functions that mkdocs calls while it builds the site: they insert the tables made from the code, and convert equations.

A line `<!-- table: metrics -->` of a page stands for a table. `<!-- keys: testbed.scenario.model:Scenario -->` stands for
the keys of a model of the package; `without` may follow, and keys that have pages of their own. A line
`<!-- file: examples/my_controller.py -->` stands for a file. The results are not committed, so they cannot be out of date.
A page of results says at its top with what it was flown, and whether the program has changed since (`benchmarks/stamps.py`).
Two flights are flown for the site, and their report and comparison are pages of it.
"""

from __future__ import annotations

import html
import re
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from mkdocs.config.defaults import MkDocsConfig
    from mkdocs.structure.files import Files

_ROOT = Path(__file__).parents[2]
sys.path[:0] = [
    str(Path(__file__).parent),
    str(_ROOT / "src"),
    str(_ROOT / "benchmarks"),
]  # the site is of this checkout, whatever is installed

import model_tables  # noqa: E402
import reference_tables  # noqa: E402
import stamps  # noqa: E402

_TABLE = re.compile(r"^<!-- (table|keys): (\S+)(?: without ([\w ]+))? -->$", flags=re.MULTILINE)
_FILE = re.compile(r"^<!-- file: (\S+\.(?:py|pl|xml|yaml)) -->$", flags=re.MULTILINE)
_INLINE = re.compile(r'<span class="arithmatex">\\\((.*?)\\\)</span>', flags=re.DOTALL)
_BLOCK = re.compile(r'<div class="arithmatex">\s*\\\[(.*?)\\\]\s*</div>', flags=re.DOTALL)


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """The site's files, with `examples/report.html` and `examples/comparison.html`: a reversed tail in turbulence, and the same
    failure flown by a controller that does not adapt beside it."""
    from mkdocs.structure.files import File

    from testbed.cli.commands import main

    scenario = str(_ROOT / "scenarios" / "reversed_in_turbulence.yaml")
    with tempfile.TemporaryDirectory() as scratch:
        runs = [Path(scratch) / name for name in ("adaptive_inversion", "fixed_inversion")]
        for run in runs:
            main(["run", scenario, "--set", f"controller.type={run.name}", "--out", str(run)])
        main(["compare", *map(str, runs), "--out", str(Path(scratch) / "comparison.html")])
        for name, page in (
            ("report", runs[0] / "report.html"),
            ("comparison", Path(scratch) / "comparison.html"),
        ):
            files.append(File.generated(config, f"examples/{name}.html", content=page.read_bytes()))
    return files


def on_page_markdown(markdown: str, **_: Any) -> str:
    """The page with tables and files in place of these lines, and its stamp in words; stops at a table that does not exist."""
    return _FILE.sub(_file, _TABLE.sub(_table, stamps.shown(markdown)))


def _file(asked: re.Match[str]) -> str:
    path = Path(asked.group(1))
    language = {".py": "python", ".pl": "perl"}.get(path.suffix, path.suffix[1:])
    return f"```{language}\n{(_ROOT / path).read_text(encoding='utf-8').rstrip()}\n```"


def _table(asked: re.Match[str]) -> str:
    kind, name, closed = asked.groups()
    if kind == "keys":
        return model_tables.keys(name, (closed or "").split())
    return reference_tables.TABLES[name]()


def on_page_content(content: str, **_: Any) -> str:
    """The page with equations as MathML, which browsers draw without scripts, fonts or network."""
    content = _BLOCK.sub(lambda found: _math(found, "block"), content)
    return _INLINE.sub(lambda found: _math(found, "inline"), content)


def _math(found: re.Match[str], display: str) -> str:
    from latex2mathml.converter import convert

    return str(convert(html.unescape(found.group(1)).strip(), display=display))
