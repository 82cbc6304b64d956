"""The only input and output: recordings and the log formats of other programs."""
