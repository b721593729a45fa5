"""One file a command: its arguments, and the lines it prints as it goes."""
