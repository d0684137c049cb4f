"""Controllers that are no Python class: a program of one's own, a C library. The only place that starts or loads them.

`reference.load` makes the factory of what a command line names; each other module flies one kind.
"""
