"""The attached device: its feed and those who look on."""
