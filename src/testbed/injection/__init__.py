"""Failures applied to a plant in flight.

`injector` starts and ends the failures when they are due. `injection` is one failure on one plant, and writes what it holds.
`receipt` checks that a failure acted, by comparing the plant with the response that the actuator should have.
"""
