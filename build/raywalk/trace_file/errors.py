"""What the format cannot hold."""

from __future__ import annotations


class TraceFileError(ValueError):
    """A ray tree of which no trace file can be written, and why."""
