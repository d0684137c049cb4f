"""The JSBSim files of an aircraft as data: read safely, and checked before JSBSim loads them.

An aircraft may come from anybody. JSBSim obeys what its files say: it opens ports, writes files, reads files outside the
aircraft's folder, and ends the process on many mistakes. `check.model_problems` is the way in.
"""
