"""From (sweep, seed, i) to the scenario of a flight.

`distributions` makes points of the unit cube, and seeds, and turns the coordinates of a point into values. `builder` sets the
values in the base scenario. `studies.plan` puts them together: run i is its method `draw(i)`.
"""
