"""The truth: the aircraft as JSBSim simulates it, its trim, and the identification of the design model from it.

`jsbsim` is the only module that imports JSBSim. `envelope` logs each control step and says whether the aircraft is lost.
`trim` finds steady flight, `identification` the design model that controllers are told, `linear` a linear model for analysis.
Servos, motors and their lags are not here: they are in the aircraft's XML, and JSBSim simulates them.
"""
