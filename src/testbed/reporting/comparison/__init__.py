"""Flights side by side: what differs between them, from which step on, and by how much."""
