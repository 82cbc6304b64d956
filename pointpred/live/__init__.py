"""Running a device: events and predictions as it moves, and where they are shown, written and sent."""
