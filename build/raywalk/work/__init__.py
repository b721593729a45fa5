"""What must be made again, and where what was made before is kept."""
