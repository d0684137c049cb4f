"""Parts of the user's own: what a file of them is made of, and `use`, which takes such files.

A file has one table for each kind of part, as the shipped parts have; each is optional:

    FAILURES = [Sticky]                     # classes of `Failure` or `ActuatorFailure`; the name is their `type`
    SENSOR_FAULTS = [Spikes]                # classes of `SensorFault`, with `valued` where they have a value
    SENSORS = {"tactical": {...}}           # presets: errors by sensor, as below `sensors` of a scenario
    METRICS = [worst_bank_deg]              # functions of a flight's `Readings`; a requirement limits one
    PANELS = [load]                         # functions of a `Flight` that give `Panel`s for its page
    REFERENCES = [weave]                    # functions (scenario, time, rows) that give the rows to fly to

`examples/my_parts.py` has one of each.
"""

from testbed.failures import ActuatorFailure, Capture, Course, Failure
from testbed.failures.base import both
from testbed.flight.flight import Flight
from testbed.metrics import Readings
from testbed.parts.files import Parts
from testbed.parts.registry import digests, in_use, take, use
from testbed.reporting.panels import Panel, Series
from testbed.scenario.load import Scenario
from testbed.sensors.faults import HOLDS, READS, REPLACED, SensorFault, Span, valued

__all__ = [
    "HOLDS", "READS", "REPLACED", "ActuatorFailure", "Capture", "Course", "Failure", "Flight", "Panel", "Parts", "Readings",
    "Scenario", "SensorFault", "Series", "Span", "both", "digests", "in_use", "take", "use", "valued",
]  # fmt: skip
