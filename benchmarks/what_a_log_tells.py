"""What of an actuator a log can tell in ten seconds, in steady flight and in turns. Writes docs/explanation/what_a_log_tells.md.

python benchmarks/what_a_log_tells.py
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from diagnose_own_flights import BASE, WEATHER, flown

PAGE = Path(__file__).parents[1] / "docs" / "explanation" / "what_a_log_tells.md"
STEADY = {name: value for name, value in BASE.items() if name not in ("commands", "command_rates")}
FLIGHTS: dict[str, dict[str, Any]] = {
    "steady, calm": STEADY,
    "turns and climbs, calm": BASE,
    "steady, gusts, MEMS": {**STEADY, **WEATHER["MEMS"]},
    "turns and climbs, gusts, MEMS": {**BASE, **WEATHER["MEMS"]},
}
SEED = 96301
_PAGE = """# What a log can and cannot tell

<!-- Written by python benchmarks/what_a_log_tells.py: change that, not this. -->

This page says when [`testbed diagnose`](../reference/diagnose.md) has no answer, and what to fly so that it has one.

A healthy flight of the v-tail, {length:g} s, seed {seed}. *Deviation* is that of an effectiveness from 10 s of the log alone (above
0.3 the page is grey); *inflation* is how much larger the other actuators make its variance; *unknown* is the share that is grey.

| flight | tail: deviation | inflation | unknown | propeller: deviation | inflation | unknown |
{line}
{rows}

- **What does not move cannot be judged.** In steady calm flight actuators hardly move, and both tails move alike: less of the left
  and less of the right look the same. Gusts move them; turns do it better. The columns are `A_alone_std` and
  `A_variance_inflation` of `diagnosis.csv`: a deviation above 0.3 says that a manoeuvre is missing, an inflation of 10 or
  more that two actuators moved alike.
- **A steady error looks like none.** A weak propeller and more drag are the same in level flight; a change is seen when it happens.
- **A force of zero has many names**: lost, held near neutral, or floating. The probabilities say so.
- A second failure while the first lasts is not looked for. Only servos can be slow or late: throttles answer to the noise of
  airspeed, which looks like it.
"""


def main() -> None:
    rows = []
    for name, scenario in FLIGHTS.items():
        found = flown({**scenario, "seed": SEED})[1]
        cells = [name]
        for actuator in ("left_ruddervator", "left_propeller"):
            i = found.actuators.index(actuator)
            medians = (float(np.median(each[:, i])) for each in (found.alone_std, found.inflation))
            cells += ["{:.2f} | {:.1f}".format(*medians), f"{100 * found.unknown_share(i):.0f} %"]
        rows.append(f"| {' | '.join(cells)} |")
    text = _PAGE.format(length=BASE["duration_s"], seed=SEED, line="| --- " * 7 + "|", rows="\n".join(rows))
    PAGE.write_text(text, encoding="utf-8")
    print(f"wrote {PAGE}")


if __name__ == "__main__":
    main()
