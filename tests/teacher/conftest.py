"""The small scene of the slides' tests."""

from ..slides.conftest import balls

__all__ = ["balls"]
