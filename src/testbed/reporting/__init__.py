"""Reports and figures of finished flights and sweeps. Nothing here flies, or depends on how the flights were made.

`run_report` and `figures` are for a run folder, `sweep_report` and `sweep_figures` for a sweep folder. Both reports write
their page with `html` and their numbers with `numbers`. `export` writes flights for other programs.
"""
