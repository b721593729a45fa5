"""Raywalk: an offline pipeline that traces teaching scenes and writes the site that replays them."""

__version__ = "0.1.0"
