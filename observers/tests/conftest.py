"""What these tests share with those of the library."""

from tests.conftest import command, recordings

__all__ = ["command", "recordings"]
