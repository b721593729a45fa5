"""Measures the tracer: accuracy and speed beside other methods, and stress cases with bounds."""
