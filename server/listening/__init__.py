"""uvicorn, with bounds on what a client may do below the messages."""
