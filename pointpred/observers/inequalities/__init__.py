"""Matrix inequalities: what is asked, the only door to a solver, and the proof of its answer."""
