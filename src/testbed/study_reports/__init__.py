"""Reports and figures of sweeps and searches, made of parts of `reporting`. Nothing here flies.

`sweep.report` and `search.report` write the page of a folder, `sweep.figures` draws a sweep's figures. `sweep.table` is the table
of a sweep as users get it.
"""
