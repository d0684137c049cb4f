"""Reading user input: YAML with line numbers, validation against models, and problems reported with their place."""
