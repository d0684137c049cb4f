"""From (sweep, seed, i) to the scenario of a flight.

`sampling` makes points of the unit cube, and seeds. `distributions` turns the coordinates of a point into values; `cases`
reads values from a table instead. `builder` sets the values in the base scenario. `studies.plan`
puts them together: run i is its method `draw(i)`.
"""
