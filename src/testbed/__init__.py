"""A flight-control failure testbed: JSBSim is the truth, a controller that has never seen it flies it broken."""
