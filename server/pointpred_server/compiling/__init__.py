"""What a first start compiles: in which order, by which process, and who waits for it."""
