"""The catalogue of public recordings, and the generated sample that the first command runs on."""
