"""Studies of pointing: a design in a TOML file, what each participant does, and the folder that keeps it."""
