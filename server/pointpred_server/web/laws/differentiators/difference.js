// Written by `make page` from difference.py: change that and run it again.
import * as $sampling from "./sampling.js";
import * as $records from "../records.js";
export const SHORTEST_S = 4;
export const AT = 5;
export const TIME = 17;
export const UX = 18;
export const VX = 20;
export const AX = 22;
export const SPAN_S = 24;
export function advance(memory, axis, u, dt) {
  const velocity = (u - memory[UX + axis]) / dt;
  if (memory[SPAN_S] > 0) {
    memory[AX + axis] = (velocity - memory[VX + axis]) / (0.5 * (dt + memory[SPAN_S]));
  }
  memory[VX + axis] = velocity;
  memory[UX + axis] = u;
}
export function step(memory, event) {
  const values_1 = $sampling.accept(memory, AT, event);
  const verdict = values_1[0];
  const start = values_1[4];
  if (verdict < 0) {
    return $records.refused(-verdict, memory[AT + $sampling.T]);
  }
  if (verdict === $sampling.RESTARTED) {
    memory.fill(0, TIME, SPAN_S + 1);
    memory[TIME] = memory[AT + $sampling.T];
  }
  const dt = memory[AT + $sampling.T] - memory[TIME];
  if (verdict === $sampling.MOVED && dt >= memory[SHORTEST_S]) {
    advance(memory, 0, memory[AT + $sampling.U], dt);
    advance(memory, 1, memory[AT + $sampling.V], dt);
    memory[TIME] = memory[AT + $sampling.T];
    memory[SPAN_S] = dt;
  }
  const velocity = [memory[VX], memory[VX + 1]];
  const acceleration = [memory[AX], memory[AX + 1]];
  const settled = $sampling.settled(memory, AT, 3, 2 * memory[SHORTEST_S]);
  return $sampling.motion(memory, AT, event, [velocity, acceleration], settled, start);
}
export const BackwardDifferentiator = {
  step: step,
  fill: $sampling.fill,
  settings: 5, learned: 0, states: 20,
  parameters: [
    { name: "cpi", unit: "counts per inch", low: 1, high: 1000000, default: null, absent: 0 },
    { name: "dpi", unit: "px per inch", low: 1, high: 100000, default: 96 },
    { name: "gap_s", unit: "s", low: 0.001, high: 1000, default: 0.1 },
    { name: "pause_s", unit: "s", low: 0.001, high: 1000, default: 0.3 },
    { name: "shortest_s", unit: "s", low: 1e-06, high: 0.1, default: 0.0001 },
  ],
};
