"""The functions of `testbed` that fly and read studies. Each does everything; its steps are what the command line uses."""
