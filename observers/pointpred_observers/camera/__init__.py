"""A moving camera: its velocity and the depth of a point, by an unknown input observer and by a filter."""

from pointpred_observers.camera.depth import Depth, DepthObserver
from pointpred_observers.camera.model import camera_box, camera_system
from pointpred_observers.camera.point_filter import PointEstimate, PointFilter
from pointpred_observers.camera.samples import CameraColumns, CameraSample, Gravity
from pointpred_observers.camera.scenario import SCENARIOS, Noise, simulate
from pointpred_observers.camera.velocity import CameraEstimate, CameraPipeline, CameraTable

__all__ = [
    "SCENARIOS",
    "CameraColumns",
    "CameraEstimate",
    "CameraPipeline",
    "CameraSample",
    "CameraTable",
    "Depth",
    "DepthObserver",
    "Gravity",
    "Noise",
    "PointEstimate",
    "PointFilter",
    "camera_box",
    "camera_system",
    "simulate",
]
