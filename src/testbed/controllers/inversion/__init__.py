"""The paper's adaptive control inversion, and what weather and real failures add to it.

`law` has the paper's equations, `estimator` the weighted estimation, `jam_detection` the test for jams, `allocation` what
to give up at a stop, `step` the order of all that in one control step. `modes` says what is released and how the rest is
inverted, `mode_trim` and `regulator` design the outer loop of a mode, `mode_switch` puts a mode in force.
"""
