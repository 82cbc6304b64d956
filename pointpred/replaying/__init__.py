"""Recordings played again: to a service, or as the mouse of a real page. Needs the extra ``client``."""

from pointpred.extras import require

require("client", "a replay to a service or a page")

from pointpred.replaying.devtools import Page, open_page  # noqa: E402
from pointpred.replaying.mouse import Driven, drive_mouse  # noqa: E402
from pointpred.replaying.socket import Replayed, ReplayedTrial, replay_to  # noqa: E402

__all__ = ["Driven", "Page", "Replayed", "ReplayedTrial", "drive_mouse", "open_page", "replay_to"]
