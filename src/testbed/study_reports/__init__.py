"""Reports of sweeps, searches, matrices and benchmarks, made of parts of `reporting`, and their tests for JUnit. Nothing here
flies.

`sweep.report` and `search.report` write the page of a folder, `sweep.figures` draws a sweep's figures. `sweep.table` is the table
of a sweep as users get it.
"""
