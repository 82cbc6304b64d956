"""Live devices: HID and evdev mice, and the cursor of the screen."""
