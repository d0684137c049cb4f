"""A user's own controller: `loader` finds the class in a file, `adapter` flies it."""
