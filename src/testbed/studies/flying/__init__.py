"""The processes that fly a study's flights.

`flight` flies one flight inside a process, and makes the record that is kept of it. `worker` is one such process, which may
crash or hang without harm to the study. `pool` gives them flights, or a Dask cluster.
"""
