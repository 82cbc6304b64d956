"""The figures of a report, drawn from the numbers of a summary: nothing is measured here."""
