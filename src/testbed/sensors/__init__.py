"""What the controller is told in place of the truth: models of sensors, and their faults.

`channels` names what is measured. `settings` and `faults` are the `sensors` block of a scenario. `measurement` is one
control step, compiled. `suite` draws the random errors before the flight, and puts all together.
"""
