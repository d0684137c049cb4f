"""Benchmarks: controllers on flights that are drawn from a suite, which says a distribution of them.

`model` has the keys of a suite's file, and `load` reads it. `grammar` draws one flight, a pure function of (suite, seed,
number). `craft` finds the suite's aircraft, and adopts those of JSBSim. `plan` is what the flights of a study need of all that.
`scores` says how each controller did, and `entry` is a result that others can check.
"""
