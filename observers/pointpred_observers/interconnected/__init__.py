"""Systems interconnected with a nonlinearity, their steady states, observers and regulators (section 3.2)."""
