"""The figures and tables of chapters 3 and 4 and of the camera paper, made again with their numbers."""
