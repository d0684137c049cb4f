"""The processes that fly a sweep's flights.

`flying` flies one flight inside a process and says what is kept of it; `child` is one such process, which may crash
or hang; `pool` runs several on this machine; `cluster` runs them on the machines of a Dask cluster.
"""
