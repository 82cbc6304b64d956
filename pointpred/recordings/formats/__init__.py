"""What each format looks like and how it is read: one file for each."""
