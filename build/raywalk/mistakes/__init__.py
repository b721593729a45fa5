"""A second tracer, small and slow, that can be told to make a student's mistakes."""
