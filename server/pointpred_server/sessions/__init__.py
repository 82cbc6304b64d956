"""One client's session, without sockets: its states, its pipeline, its targets and trials, its limits."""
