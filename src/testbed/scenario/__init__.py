"""What a scenario file may say, the checks of it, and the references that the controller is to follow."""
