"""What people are shown of a finished flight or sweep. Nothing here flies, or knows how the flights were made.

`run_report` and `figures` are of a run folder, `sweep_report` and `sweep_figures` of a sweep folder; `html` and
`numbers` are how every report writes a page and a number.
"""
