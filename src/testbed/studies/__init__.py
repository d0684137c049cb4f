"""Monte Carlo sweeps: many flights with values drawn at random, made from one scenario, and the statistics of their results.

`load` reads a sweep file, with the keys of `model`, into a `plan`. The plan says what run i is, a pure function of (sweep,
seed, i). `checks` refuses plans with invalid scenarios. `run` flies a plan, with `progress` and `stopping`. `summary`
evaluates the table of results, with `statistics` and `sensitivity`. The packages: `drawing` draws values and makes
scenarios from them, `workers` are the processes that fly, and `folder` writes the sweep folder and reads it back.
"""
