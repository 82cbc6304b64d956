"""The figures and tables of the thesis and of the camera paper, made again with their numbers."""
