"""Plants, generators and steady states: as matrices, as symbols, and in files."""
