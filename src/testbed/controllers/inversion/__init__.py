"""The paper's adaptive control inversion, and what weather and real failures add to it.

`step` is one control step, in order. It calls `law` (the paper's equations), `lateness` (delayed actuators), `estimator`
(weighted estimation), `jam_detection` (the test for jams), `swing_detection` (what swings is not jammed) and `allocation` (what
to give up when an actuator reaches a stop, by `bounded_least_squares`). `modes` says which axes are released after a failure and
how the others are inverted. `mode_trim` and `regulator` design the outer loop of such a mode, and `mode_switch` puts a mode in
force.
"""
