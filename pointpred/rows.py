"""Until every import follows: the names of ``pointpred.records``."""

from pointpred.records import (
    EventRow as EventRow,
)
from pointpred.records import (
    MotionRow as MotionRow,
)
from pointpred.records import (
    PredictionRow as PredictionRow,
)
from pointpred.records import (
    Row as Row,
)
from pointpred.records import (
    SixFloats as SixFloats,
)
from pointpred.records import (
    TenFloats as TenFloats,
)
from pointpred.records import (
    endpoint as endpoint,
)
from pointpred.records import (
    event_at as event_at,
)
from pointpred.records import (
    event_of as event_of,
)
from pointpred.records import (
    event_row as event_row,
)
from pointpred.records import (
    motion_of as motion_of,
)
from pointpred.records import (
    motion_row as motion_row,
)
from pointpred.records import (
    prediction_of as prediction_of,
)
from pointpred.records import (
    prediction_row as prediction_row,
)
from pointpred.records import (
    refused as refused,
)
from pointpred.records import (
    row_at as row_at,
)
