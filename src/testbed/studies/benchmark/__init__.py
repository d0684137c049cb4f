"""Benchmarks: controllers on flights that are drawn from a suite, which says a distribution of them.

`model` has the keys of a suite's file, and `load` reads it, finds the aircraft and adopts those of JSBSim. `plan` has draw i, a
pure function of (suite, seed, i): it seeds the dice by which `grammar` draws a flight.
`limits` says what *held* means. `scores` says how each controller did, and `entry` is a result that others can check.
"""
