"""Searches: the smallest failure that breaks a requirement, and the probability of a rare one.

`load` reads a search file, with the keys of `model`, into a `plan`. Every value that varies has a coordinate in `space`, a
standard normal number, so that distance from the origin is a measure of likelihood. `limit_state` is a flight as a function of
these coordinates: its robustness, negative where a requirement is not met. `reliability` has the mathematics, which knows
nothing of flights. `flying` flies a batch with the sweeps' own workers, `folder` keeps every flight, so that a search which was
killed goes on where it was, and `run` puts them together.
"""
