"""What is said on the wire: messages, binary records, and how frames are read and refused."""
