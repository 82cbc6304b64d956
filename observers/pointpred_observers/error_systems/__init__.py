"""Error systems: how fast an error decays, and how much a disturbance is amplified."""
