"""How wrong the input matrix of a scenario's design model may be: `testbed certify`."""
