"""Commands that measure the project and write its generated pages; nothing here is installed."""
