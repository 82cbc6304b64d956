"""Tables of samples: the meaning of columns, their units, and rows as trials."""
