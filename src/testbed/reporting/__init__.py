"""Figures and reports of flights and sweeps, made from what is on disk."""
