"""Reading user input: YAML with line numbers, validation against models, and problems reported with their place.

`validation` finds all problems of a file and puts each into words, and `problems` says what was probably meant.
"""
