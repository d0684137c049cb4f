"""The command line: `commands` has the parser and the exit status, and the other modules carry the commands out.

`flight` flies one scenario and reports a run folder; `sweep` does the same for a sweep; `checked` reads and checks input;
`export` writes a flight for other programs; `aircraft` identifies design models; `catalogue` lists what is available;
`completion` completes commands in a shell; `working` says on a terminal what takes long.
"""
