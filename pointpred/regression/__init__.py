"""Linear regression on line: unknown constants from what is measured, and how far the data reach."""
