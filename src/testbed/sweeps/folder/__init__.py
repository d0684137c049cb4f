"""A sweep's folder on disk.

While the sweep is flown, `store` writes a line of `journal` and a record of `histories` for each finished flight.
`resuming` decides whether an existing folder may be used. At the end `results` writes the table, results.csv and
results.parquet. `reading` reads a folder back, whether the sweep is finished or not.
"""
