"""Ray trees as small, self-describing files; FORMAT.md says what is in them and why."""
