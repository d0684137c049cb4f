"""A failure matrix: every actuator of an aircraft by every failure that fits it, and what is expected of each."""
