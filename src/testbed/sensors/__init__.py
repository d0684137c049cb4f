"""What the controller is told in place of the truth: models of sensors, and their faults.

`channels` names what is measured. `settings`, `mems` and `faults` are the `sensors` block of a scenario. `errors` draws the
random errors before the flight. `measurement` is one control step, compiled. `suite` puts them together.
"""
