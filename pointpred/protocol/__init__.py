"""The messages on the wire, packed records, and how frames are made, read and refused."""
