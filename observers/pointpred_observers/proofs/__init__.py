"""Matrix inequalities, their search and their audit, and what is proved with them."""
