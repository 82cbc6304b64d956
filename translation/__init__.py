"""The laws in JavaScript: a translator from the law language, and what writes the modules of the page."""
