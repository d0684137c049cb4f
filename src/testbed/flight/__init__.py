"""A finished flight, read without the simulator.

`flight` has the class `Flight`, and how flights end; `folder` writes and reads its run folder. `columns` names and fills the
columns of the log, and finds rows in it. `breakage` says what was broken since when, whether the aircraft recovered, and when the
controller noticed, `events` what the controller did (detections with their delay) and why the aircraft was lost, and `requirements`
which requirements were met.
"""
