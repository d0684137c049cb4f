"""A finished flight, read without the simulator.

`flight` is the flight itself, `display` how it is shown in a terminal or a notebook, `folder` how it is written and read
back; `columns` names and fills the log, and `rows` finds rows in it; `breakage` says what was broken and since when,
`events` what the controller did, and `verdict` which requirements were met.
"""
