"""What the controller is told in place of the truth: models of sensors, and their faults.

`channels` names what is measured, `settings`, `mems` and `faults` are the YAML, `errors` draws what is random
before the flight, `measurement` is the compiled step, `suite` puts them together.
"""
