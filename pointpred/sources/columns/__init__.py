"""Any table of samples: which column is what, its units, and its rows as trials."""
