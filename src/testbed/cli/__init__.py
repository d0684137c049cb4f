"""The command line: `commands` is the parser and the exit status, and the other modules are what commands do.

`flight` flies one scenario and reports a run folder; `sweep` does the same for many flights; `checked` reads and
checks input; `aircraft` finds design models; `catalogue` lists what there is; `completion` is for shells.
"""
