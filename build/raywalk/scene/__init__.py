"""Scene files: TOML in, validated scenes out. Start with read.py."""
