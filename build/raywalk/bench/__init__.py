"""Measures the tracer: accuracy and speed beside other ways, and stress cases with bounds."""
