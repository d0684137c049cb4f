"""Studies: many flights made from one scenario, as sweeps by values drawn at random, and searches for failures.

`load` reads a study's file, with the keys of `model`, into a `plan`, which says each flight: run i is a pure function of (study,
seed, i). `checks` refuses plans with invalid scenarios. `run` flies any plan, or a shard of it, into its folder, and a sweep only
up to where it may stop; `summary` evaluates its table. `matrix` breaks every actuator in every way. The packages: `search` chooses
its flights as it goes, `benchmark` compares controllers, `drawing` draws values and makes scenarios of them, `flying` has the
processes that fly, `folder` writes a study's folder.
"""
