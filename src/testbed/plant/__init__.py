"""The truth: the aircraft as JSBSim simulates it, its trim, and the identification of the design model from it."""
