"""The paper's adaptive control inversion, and what weather and real failures add to it.

`controller` is what a flight calls, and `step` one control step of it, in order. In each step `step` calls

* `sensor_guard`: what stuck sensors do not say;
* `law`: the paper's equations;
* `estimator`: weighted estimation, Kalman filters, in place of the paper's (13), and for actuators that act late;
* `loss_detection`: the paper's monitor, and what the default law asks beyond it;
* `probing`: whether what is given up works again;
* `offset_detection` and `jam_detection`: failures that are no loss of effectiveness;
* `allocation`: what to give up when an actuator reaches a stop.

`evidence` has what all of them ask of evidence.

When a failure is flagged, `mode_switch` puts another control mode in force. `modes` says which axes it releases and how the others
are inverted. `regulator` designs the outer loop of a mode with released axes, about the trim that `mode_trim` chooses among the
`steady_flights` of the `degraded_aircraft`.
"""
