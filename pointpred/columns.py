"""Until every import follows: the names of ``pointpred.records``."""

from pointpred.records import (
    BoolArray as BoolArray,
)
from pointpred.records import (
    Columns as Columns,
)
from pointpred.records import (
    EventColumns as EventColumns,
)
from pointpred.records import (
    FloatArray as FloatArray,
)
from pointpred.records import (
    MotionColumns as MotionColumns,
)
from pointpred.records import (
    PredictionColumns as PredictionColumns,
)
from pointpred.records import (
    RegionColumns as RegionColumns,
)
