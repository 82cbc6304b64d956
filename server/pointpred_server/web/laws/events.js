// Written by `make page` from events.py: change that and run it again.
export const LATEST_S = 100000000000;
export const LARGEST = 1000000000;
export const METRES_PER_INCH = 0.0254;
export const ROUNDING_S = 1e-06;
