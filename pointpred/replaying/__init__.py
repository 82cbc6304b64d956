"""Recordings played again: to a service over its socket, or as the mouse of a real page."""

from pointpred.replaying.devtools import Page, open_page
from pointpred.replaying.mouse import Driven, drive_mouse
from pointpred.replaying.socket import Replayed, ReplayedTrial, replay_to

__all__ = ["Driven", "Page", "Replayed", "ReplayedTrial", "drive_mouse", "open_page", "replay_to"]
