"""The unknown input observer of depth at run time: its reduced form, two numbers and no gain."""

from __future__ import annotations

from math import ceil

import msgspec

from pointpred.camera.camera_stage import LARGEST_PX, SUBSTEP_S, CameraStage, usable
from pointpred.camera.samples import FOCAL, CameraColumns, CameraSample
from pointpred.columns import BoolArray, Columns, FloatArray
from pointpred.compiled import law
from pointpred.observers.unknown_input.observer import UnknownInputObserver
from pointpred.parameter import Parameter, check

NONE = float("nan")
LARGEST_RATE = 1e3
"""Beyond this |eta| 1/s the camera meets the point within a millisecond: the estimate is lost."""

FOCAL_PX, HALF_SIGMA, START_CHI, START_ETA, GAP_S, BOX = 0, 1, 2, 3, 4, 5
STARTED = BOX + 10  # bounds of zero, eta, a_z, w_x, w_y, low before high
T, X, Y, WX, WY, WZ, AZ = range(STARTED + 1, STARTED + 8)
CHI, R, SEEN, LOST = range(STARTED + 8, STARTED + 12)
STATES = 12


@law
def rate(
    chi: float,
    r: float,
    x: float,
    y: float,
    wx: float,
    wy: float,
    wz: float,
    az: float,
    dwx: float,
    dwy: float,
) -> tuple[float, float]:
    """(chi, r)' with r = eta + w_y x - w_x y, the last row of T x: no unknown input in it."""
    eta = r - wy * x + wx * y
    flow_x = x * y * wx - (1.0 + x * x) * wy + y * wz
    flow_y = (1.0 + y * y) * wx - x * y * wy - x * wz
    known = wy * flow_x - wx * flow_y + dwy * x - dwx * y
    return (y * wx - x * wy + eta) * chi, az * chi + eta * eta + known


@law
def carry(
    memory: FloatArray, x: float, y: float, wx: float, wy: float, wz: float, az: float, dt: float
) -> None:
    """Move (chi, r) over ``dt`` s by Runge-Kutta, every measured quantity on a line between two samples."""
    x0, y0, az0 = memory[X], memory[Y], memory[AZ]
    wx0, wy0, wz0 = memory[WX], memory[WY], memory[WZ]
    dwx, dwy = (wx - wx0) / dt, (wy - wy0) / dt
    steps = ceil(dt / SUBSTEP_S)
    h = dt / steps
    for i in range(steps):
        chi, r = memory[CHI], memory[R]
        sum_chi, sum_r, k_chi, k_r = 0.0, 0.0, 0.0, 0.0
        for stage in range(4):
            inner = 0.0 if stage == 0 else (1.0 if stage == 3 else 0.5)
            s = (i + inner) / steps
            k_chi, k_r = rate(
                chi + inner * h * k_chi,
                r + inner * h * k_r,
                x0 + s * (x - x0),
                y0 + s * (y - y0),
                wx0 + s * (wx - wx0),
                wy0 + s * (wy - wy0),
                wz0 + s * (wz - wz0),
                az0 + s * (az - az0),
                dwx,
                dwy,
            )
            share = 1.0 if stage == 0 or stage == 3 else 2.0
            sum_chi += share * k_chi
            sum_r += share * k_r
        memory[CHI] = chi + h / 6.0 * sum_chi
        memory[R] = r + h / 6.0 * sum_r
        if not (abs(memory[R]) <= LARGEST_RATE and abs(memory[CHI]) <= LARGEST_PX):
            memory[LOST] = 1.0
            memory[CHI], memory[R] = chi, r
            return


@law
def inside(memory: FloatArray, zero: float, eta: float) -> bool:
    """Whether what the certificate speaks of lies in its box; never where there is no certificate."""
    values = (zero, eta, memory[AZ], memory[WX], memory[WY])
    for i in range(5):
        if not memory[BOX + 2 * i] <= values[i] <= memory[BOX + 2 * i + 1]:
            return False
    return bool(memory[BOX] < 0.0)


@law
def step(
    memory: FloatArray,
    t: float,
    x: float,
    y: float,
    wx: float,
    wy: float,
    wz: float,
    ax: float,
    ay: float,
    az: float,
) -> tuple[float, float, float, float, float, float, float]:
    """One sample: t, chi, eta, the zero of chi, detectable, certified, whether there was an image."""
    if not usable(t, x, y, wx, wy, wz, ax, ay, az, memory[STARTED], memory[T], memory[GAP_S]):
        return NONE, NONE, NONE, NONE, 0.0, 0.0, 0.0
    image = x == x
    flat_x = x / memory[FOCAL_PX] if image else memory[X]
    flat_y = y / memory[FOCAL_PX] if image else memory[Y]
    if memory[SEEN] == 0.0 and image:
        memory[CHI] = memory[START_CHI]
        memory[R] = memory[START_ETA] + wy * flat_x - wx * flat_y
        memory[SEEN] = 1.0
    elif memory[SEEN] == 1.0 and memory[LOST] == 0.0:
        carry(memory, flat_x, flat_y, wx, wy, wz, az, t - memory[T])
    memory[STARTED] = 1.0
    memory[T], memory[X], memory[Y] = t, flat_x, flat_y
    memory[WX], memory[WY], memory[WZ], memory[AZ] = wx, wy, wz, az
    if memory[SEEN] == 0.0 or memory[LOST] == 1.0:
        return t, NONE, NONE, NONE, 0.0, 0.0, 1.0 if image else 0.0
    eta = memory[R] - wy * flat_x + wx * flat_y
    zero = flat_y * wx - flat_x * wy + eta
    decays = zero < -memory[HALF_SIGMA] and eta < -memory[HALF_SIGMA]
    proved = inside(memory, zero, eta)
    return (
        t,
        memory[CHI],
        eta,
        zero,
        1.0 if decays else 0.0,
        1.0 if proved else 0.0,
        1.0 if image else 0.0,
    )


@law
def loop(memory: FloatArray, first: int, begin: BoolArray, rows: FloatArray, out: FloatArray) -> None:
    """The same step over a table."""
    for i in range(len(rows)):
        if begin[i]:
            memory[first:] = 0.0
        r = rows[i]
        answer = step(memory, r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8])
        for j in range(len(answer)):
            out[i, j] = answer[j]


class Depth(msgspec.Struct, frozen=True):
    """What the observer says after a sample.

    ``chi`` = 1/Z 1/m, ``eta`` = v_z/Z 1/s and ``zero`` = y w_x - x w_y + eta 1/s, NaN before the first image
    and where the estimate is lost; ``detectable`` while both zeros, as estimated, lie below -sigma/2;
    ``certified`` while they and the measured quantities lie in the box of the design as well.
    """

    t: float
    chi: float
    eta: float
    zero: float
    detectable: bool
    certified: bool
    image: bool


class DepthColumns(Columns[Depth]):
    """Depths as columns."""

    names = ("t", "chi", "eta", "zero", "detectable", "certified", "image")

    def _record(self, row: list[float]) -> Depth:
        t, chi, eta, zero, detectable, certified, image = row
        return Depth(t, chi, eta, zero, bool(detectable), bool(certified), bool(image))


class DepthObserver(CameraStage):
    """Depth and forward velocity of a point from its image, a gyroscope and an accelerometer.

    What it cannot do: with two unknown inputs and two outputs nothing corrects chi and eta. The model carries
    their start values on; errors fade only while the camera recedes, v_z is the integral of the accelerometer
    from its start, and the relative error of the depth ends where that of v_z is. ``detectable`` judges its
    own estimate: an observer started with the wrong sign of v_z does not notice by itself (``CameraPipeline``
    asks the images).

    chi' = (y w_x - x w_y + eta) chi; r' = a_z chi + eta^2 + w_y B_1 w - w_x B_2 w + w_y' x - w_x' y with
    eta = r - w_y x + w_x y: the last two rows of T x, which no unknown input reaches. Between two samples
    every measured quantity lies on a line, so w' is the slope of the gyroscope's readings and no angular
    accelerometer is needed. Without an image x and y stay where they were seen last.

    Parameters: ``focal_px`` px; ``start_chi`` 1/m and ``start_eta`` 1/s; ``gap_s`` s, the longest silence
    that is bridged; ``observer``, a design whose sigma and box the flags speak of: without one sigma is 0 and
    nothing is certified. Memory: 27 floats. Returns a Depth from ``update``, DepthColumns from ``run``.
    Raises ParameterError; EventError and EventOrderError from ``update`` and ``run``.

    Reference: Benyoucef et al. 2021, equations (12), (15) to (18), the signs corrected.

    >>> observer = DepthObserver(focal_px=800.0, start_chi=1.0, start_eta=-0.5)
    >>> for i in range(101):  # backwards at 0.5 m/s from 1 m
    ...     depth = observer.update(CameraSample(i / 100, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    >>> round(1.0 / depth.chi, 6), round(depth.eta / depth.chi, 6), depth.detectable, depth.certified
    (1.5, -0.5, True, False)
    """

    parameters = (
        FOCAL,
        Parameter("start_chi", "1/m", 1e-6, 1e6, "inverse depth at the first image"),
        Parameter("start_eta", "1/s", -1e3, 1e3, "v_z/Z at the first image"),
        Parameter("gap_s", "s", 1e-3, 10.0, "longest silence of the inertial sensor that is bridged"),
    )
    width = 7
    step = staticmethod(step)
    loop = staticmethod(loop)
    at_started, at_t, at_gap = STARTED, T, GAP_S

    def __init__(
        self,
        *,
        focal_px: float,
        start_chi: float,
        start_eta: float,
        gap_s: float = 1.0,
        observer: UnknownInputObserver | None = None,
    ) -> None:
        own = {"focal_px": focal_px, "start_chi": start_chi, "start_eta": start_eta, "gap_s": gap_s}
        check(self.parameters, own)
        half, box = 0.0, [0.0] * 10
        if observer is not None:
            half = 0.5 * observer.certificate.sigma
            box = [bound for pair in list(observer.box.bounds.values())[:5] for bound in pair]
        settings = [float(focal_px), half, float(start_chi), float(start_eta), float(gap_s), *box]
        self.lay_out(settings, STATES)
        self.focal_px, self.half_sigma = float(focal_px), half

    def update(self, sample: CameraSample, /) -> Depth:
        """Consume one sample; a refused one changes nothing."""
        t, chi, eta, zero, detectable, certified, image = self.advance(sample)
        return Depth(t, chi, eta, zero, detectable == 1.0, certified == 1.0, image == 1.0)

    def run(self, columns: CameraColumns) -> DepthColumns:
        """Consume a table; when a row is refused the error names it and nothing is consumed."""
        return DepthColumns(self.table(columns))
