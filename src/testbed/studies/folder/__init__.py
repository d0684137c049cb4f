"""A study's folder on disk.

`begin` decides whether a folder may be used, and says in it which study it is. While the study is flown, each finished flight goes
into the database of `store`. At the end `table` writes results.csv and results.parquet, and reads a folder back, whether
the study is finished or not; `logs` has what is kept of a flight's course.
"""
