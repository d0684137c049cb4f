"""A resolved matrix: its cells, what the baseline expects of each, and the flights that are made of it."""

from __future__ import annotations

from dataclasses import dataclass

from testbed.studies.matrix.cells import Cell
from testbed.studies.matrix.model import Expected, Matrix, Result
from testbed.studies.plan import Plan


@dataclass(frozen=True, kw_only=True)
class MatrixPlan(Plan):
    """A resolved matrix. As a plan it is a table of cases: `seeds` runs of each cell that is possible, one after the other."""

    study: Matrix
    cells: tuple[Cell, ...]

    @property
    def flown(self) -> list[Cell]:
        """The cells that are possible, in the order of the runs."""
        return [cell for cell in self.cells if cell.broken is not None]

    @property
    def labels(self) -> list[str]:
        """The names of the controllers, or of whatever else is compared."""
        alone = str((self.builder.base.tree.get("controller") or {}).get("type", "adaptive_inversion"))
        return [variant.label or alone for variant in self.variants]

    def variant_of(self, controller: str) -> str:
        """The label of the variant that this controller flies: empty where nothing is compared."""
        return self.variants[self.labels.index(controller)].label

    def expected(self, cell: Cell, label: str) -> Result:
        """What the baseline says of a cell that this controller flies; else that it is held, if it is possible."""
        said = [each.result for each in self.study.baseline if about(each, cell, label)]
        return said[-1] if said else "held" if cell.broken is not None else "not possible"


def about(expected: Expected, cell: Cell, label: str) -> bool:
    """Whether an entry of a baseline is about a cell that this controller flies."""
    asked = expected.model_dump(exclude={"result"}, exclude_none=True)
    return all(
        (label if key == "controller" else getattr(cell, key)) == value for key, value in asked.items()
    )
