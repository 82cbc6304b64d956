"""Sessions of simulated people on a simulated desktop: windows, menus, and habits that may change."""

from pointpred.simulation.desktop.scenario import SCENARIOS, Scenario
from pointpred.simulation.desktop.session import DesktopSession, simulate_desktop

__all__ = ["SCENARIOS", "DesktopSession", "Scenario", "simulate_desktop"]
