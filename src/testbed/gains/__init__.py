"""Gains of the estimator from a scenario's noise, with what they are expected to do: `testbed design`."""
