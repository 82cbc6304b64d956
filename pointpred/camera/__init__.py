"""A moving camera: its velocity and the depth of a point, by an unknown input observer and by a filter."""

from pointpred_observers.camera.bounds import consistent, cramer_rao, normalised_errors
from pointpred_observers.camera.depth import Depth, DepthColumns, DepthObserver
from pointpred_observers.camera.model import camera_box, camera_system, depth_rate, point_rate
from pointpred_observers.camera.pipeline import CameraEstimate, CameraPipeline, CameraTable
from pointpred_observers.camera.point_filter import PointEstimate, PointFilter, PointTrack
from pointpred_observers.camera.samples import CameraColumns, CameraSample, Noise, simulate
from pointpred_observers.camera.scenario import SCENARIOS, Scenario, Trajectory, trajectory
from pointpred_observers.camera.velocity import WAYS, UnknownInputs, velocities

__all__ = [
    "SCENARIOS",
    "WAYS",
    "CameraColumns",
    "CameraEstimate",
    "CameraPipeline",
    "CameraSample",
    "CameraTable",
    "Depth",
    "DepthColumns",
    "DepthObserver",
    "Noise",
    "PointEstimate",
    "PointFilter",
    "PointTrack",
    "Scenario",
    "Trajectory",
    "UnknownInputs",
    "camera_box",
    "camera_system",
    "consistent",
    "cramer_rao",
    "depth_rate",
    "normalised_errors",
    "point_rate",
    "simulate",
    "trajectory",
    "velocities",
]
