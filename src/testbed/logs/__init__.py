"""Real flights and our own, from their logs: which actuator failed, when, and how much.

`entry` and `mapped` read a log into a `flight_log.FlightLog`. `regression` runs the law's (10) over it, and makes its errors
white, `hypotheses` says what each actuator may have done, and finds the likeliest course of these and effectiveness with
its uncertainty. `diagnosis` is all of it, `page` what is shown of it, and `entry` what users call.
"""
