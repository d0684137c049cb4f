"""Reading what a user wrote: YAML with its line numbers, checked models, and every problem in words with its place."""
