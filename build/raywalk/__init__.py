"""Raywalk: traces teaching scenes offline and writes the site that replays every ray."""

__version__ = "0.1.0"
