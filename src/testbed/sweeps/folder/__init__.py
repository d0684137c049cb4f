"""A sweep's folder on disk.

While it is flown, `store` writes it: a line of `journal` and a record of `histories` for each finished flight;
`resuming` says whether an existing folder may be used. Then `results` writes the table, results.csv and
results.parquet. `reading` reads a folder back, finished or not.
"""
