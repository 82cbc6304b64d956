"""A law of the endpoint that is a mixture of Student and normal laws, and the level sets of its density."""
