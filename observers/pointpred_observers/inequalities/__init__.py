"""Matrix inequalities: the problem, the only interface to a solver, and the audit of its answer."""
