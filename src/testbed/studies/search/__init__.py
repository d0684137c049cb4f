"""Searches: the smallest failure that breaks a requirement, and the probability of a rare one.

`plan` reads a search file into its parts. Every value that varies has a coordinate in a space, a standard normal number, so that
distance from the origin is a measure of likelihood. `reliability` has the mathematics, which knows nothing of flights. `run` gives
it the robustness of a flight as a function of these coordinates, and says what was found.

A search that is resumed is done again from its beginning, with the flights of its store in place of those that have been flown. So
its answer has the same bytes as that of a search without interruption.
"""
