"""Files: their encoding, their names, folders, and writing several at once."""
