"""The air that the aircraft flies in: wind, gusts and turbulence."""
