"""What is measured of one trial: the error of the endpoint, regions, the time left, hits in the target."""
