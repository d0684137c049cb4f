"""What every package may use: units, angles, frames, signals, the clock, random streams, files, compiling."""
