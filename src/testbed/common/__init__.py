"""What every package may use: units, angles, frames, signals, random streams, files, compiling."""
