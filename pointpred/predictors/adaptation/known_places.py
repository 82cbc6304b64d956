"""The known places of a window as a table: where they are, and how likely each is the destination now."""

from __future__ import annotations

from pointpred.compiled import law
from pointpred.predictors.adaptation import correction, destination, places
from pointpred.predictors.adaptation.correction import Parts
from pointpred.records import FloatArray
from pointpred.scene import Scene

# A row: position in px, shares now and before the movement, visits, the number of the place, the standard
# deviation of its visits in px.
X, Y, P, BEFORE, VISITS, NUMBER, SPREAD, FIELDS = range(8)


@law
def last_end(memory: FloatArray, known: int, key: float) -> tuple[float, float]:
    """Where the last movement to a place of this key ended, px from the origin; the origin if none did."""
    for age in range(places.MOVEMENTS):
        number = places.visited(memory, known, age)
        place = known + places.PLACES + places.WIDTH * max(number, 0)
        if number >= 0 and memory[place + places.KEY] == key:
            return float(memory[place + places.X]), float(memory[place + places.Y])
    return 0.0, 0.0


@law
def list_places(memory: FloatArray, person: int, at: int, parts: Parts, scene: Scene, out: FloatArray) -> int:
    """Fill a row for each place of the scene, in the order of their numbers; returns how many there are.

    ``out``: ``places.CAPACITY`` rows of FIELDS. Before a movement has begun the shares are those of a
    movement from where the last one in this scene ended.
    """
    known, going = person + correction.KNOWN, at + correction.DESTINATION
    waits = memory[going + destination.READY] == 0.0
    start = memory[at + correction.X0] - scene.x, memory[at + correction.Y0] - scene.y
    if waits:
        if memory[at + correction.STARTED] == 0.0:
            start = last_end(memory, known, scene.key)
        correction.prepare(memory, person, going, parts, scene, start)
    count, returns = 0, memory[going + destination.RETURNS]
    for i in range(int(memory[known + places.COUNT])):
        place = known + places.PLACES + places.WIDTH * i
        if memory[place + places.KEY] == scene.key:
            x, y = memory[place + places.X], memory[place + places.Y]
            before = returns * memory[going + destination.BEFORE + i]
            out[count, X], out[count, Y] = x + scene.x, y + scene.y
            out[count, P] = before if waits else memory[going + destination.NOW + i]
            out[count, BEFORE], out[count, VISITS] = before, memory[place + places.WEIGHT]
            out[count, NUMBER] = i
            out[count, SPREAD] = destination.spread_of(memory, going, start, x, y)
            count += 1
    if waits:  # the movement lays them out for where it starts
        memory[going : going + destination.STATES] = 0.0
    return count
