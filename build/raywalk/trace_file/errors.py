"""What can be wrong with a trace file, with a code for whoever words it for a person."""

from __future__ import annotations

# "damaged": bytes are missing or changed; "not-a-trace": another kind of file;
# "version": written for another reader; "scene": of another scene or resolution;
# "unfit": a ray tree this format cannot hold (only when writing).
CODES = ("damaged", "not-a-trace", "version", "scene", "unfit")


class TraceFileError(ValueError):
    """A trace file that must not be used, and why."""

    def __init__(self, code: str, message: str):
        assert code in CODES
        self.code = code
        super().__init__(message)
