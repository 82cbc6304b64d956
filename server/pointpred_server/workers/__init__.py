"""Several processes as one service: who gets a connection, who is restarted, and sums over all of them."""
