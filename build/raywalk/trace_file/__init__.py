"""Ray trees as small, self-describing files; FORMAT.md says what is in them and why."""

from raywalk.trace.tree import Kind, Visibility
from raywalk.trace_file.decode import DecodedTrace, decode, read_trace
from raywalk.trace_file.encode import encode
from raywalk.trace_file.errors import TraceFileError
from raywalk.trace_file.level import level_of
from raywalk.trace_file.write import write_level

__all__ = [
    "DecodedTrace", "Kind", "TraceFileError", "Visibility", "decode", "encode", "level_of",
    "read_trace", "write_level",
]  # fmt: skip
