"""From (sweep, seed, i) to the scenario of a flight.

`sampling` makes points of the unit cube and seeds, `distributions` turns a point into the values that a run has,
`cases` reads them from a table instead, and `builder` sets them in the base scenario.
"""
