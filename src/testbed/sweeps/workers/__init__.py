"""The processes that fly a sweep's flights.

`flying` flies one flight inside a process, and makes the record that is kept of it. `worker` is one such process, which may
crash or hang without harm to the sweep. `pool` runs several on this machine, `cluster` on the machines of a Dask cluster.
"""
