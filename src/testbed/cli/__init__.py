"""The command line: a module for each command, named after it.

Such a module has PURPOSE, one line of `--help`; EXAMPLES, lines as a user would type them; `arguments`, which gives its parser the
arguments; and `run`, which carries it out with the parsed options and returns the exit status. It imports what it needs only when
it runs, so that `--help` and `validate` stay quick.

`commands` lists the commands, runs one and says in one line what goes wrong, `ending` has the exit status and Ctrl-C. `command` has
what commands share; `terminal` prints, and says what takes long.
"""
