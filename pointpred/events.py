"""Until every import follows: the names of ``pointpred.records``."""

from pointpred.records import (
    CPI as CPI,
)
from pointpred.records import (
    DPI as DPI,
)
from pointpred.records import (
    LARGEST as LARGEST,
)
from pointpred.records import (
    LATEST_S as LATEST_S,
)
from pointpred.records import (
    METRES_PER_INCH as METRES_PER_INCH,
)
from pointpred.records import (
    NORMAL as NORMAL,
)
from pointpred.records import (
    PHASES as PHASES,
)
from pointpred.records import (
    ROUNDING_S as ROUNDING_S,
)
from pointpred.records import (
    Motion as Motion,
)
from pointpred.records import (
    Pair as Pair,
)
from pointpred.records import (
    Phase as Phase,
)
from pointpred.records import (
    Place as Place,
)
from pointpred.records import (
    PointerEvent as PointerEvent,
)
from pointpred.records import (
    Prediction as Prediction,
)
