"""The truth: JSBSim behind one door, its trim, and the identification of the design model from it."""
