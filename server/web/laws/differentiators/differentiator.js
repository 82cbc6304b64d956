// Written by `make page` from differentiator.py: change that and run it again.
export function event_at(rows, i) {
  const r = rows[i];
  return [r[0], r[1], r[2], r[3], r[4], r[5]];
}
