"""The model of a scenario file, its checks, and the references that the controller is to follow."""
