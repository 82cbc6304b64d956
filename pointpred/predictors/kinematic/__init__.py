"""The learned predictor: what a movement has shown so far, through a small network."""
