"""The command line: a file for each command, named after it, with its arguments, its examples and what it does.

`parser` lists the commands, `commands` runs one and says in one line what goes wrong, `status` has the exit status. `command` has
what commands share; `checked` reads and checks a scenario; `working` says on a terminal what takes long.
"""
