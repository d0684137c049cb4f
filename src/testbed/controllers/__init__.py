"""Controllers, one file each, and their settings."""
