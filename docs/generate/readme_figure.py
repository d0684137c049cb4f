"""The picture of the README: three controllers, one failure. Run it from the repository, with the simulator installed.

python docs/generate/readme_figure.py
"""

from __future__ import annotations

from pathlib import Path

import testbed
from testbed.common.files import replacing
from testbed.flight.flight import Flight
from testbed.reporting.comparison.compare import Comparison
from testbed.reporting.comparison.figure import picture
from testbed.scenario.load import load_scenario

SCENARIO = "scenarios/reversed_ruddervator.yaml"
CONTROLLERS = ("adaptive_inversion", "fixed_inversion", "pid")
FILE = Path(__file__).parents[1] / "figures/three_controllers.png"


def flights() -> list[Flight]:
    """The scenario, flown by each controller."""
    return [testbed.fly(load_scenario(SCENARIO, [f"controller.type={name}"])) for name in CONTROLLERS]


def main() -> None:
    """Write the picture."""
    with replacing(FILE) as partial:
        partial.write_bytes(picture(Comparison(flights())))
    print(f"wrote {FILE}")


if __name__ == "__main__":
    main()
