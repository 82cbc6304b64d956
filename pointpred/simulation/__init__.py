"""The closed pointing loop with seeded people."""
