"""Files that hold any table: one file for each format."""
