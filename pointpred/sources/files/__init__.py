"""Files before they are understood: their encoding, their names, folders, and writing several at once."""
