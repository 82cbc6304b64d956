// Written by `make laws` from difference.py: change that and run it again.
import * as $sampling from "./sampling.js";
import * as $records from "../records.js";
export function advance(last, axis, u, dt, last_at = 0) {
  const velocity = (u - last[last_at + axis + 1]) / dt;
  if (last[last_at + 7] > 0) {
    last[last_at + axis + 5] = (velocity - last[last_at + axis + 3]) / (0.5 * (dt + last[last_at + 7]));
  }
  last[last_at + axis + 3] = velocity;
  last[last_at + axis + 1] = u;
}
export function step(memory, event, memory_at = 0) {
  const settings_at = memory_at;
  const samples_at = memory_at + 5;
  const last_at = memory_at + 17;
  const values_1 = $sampling.accept(memory, memory, event, settings_at, samples_at);
  const verdict = values_1[0];
  const start = values_1[4];
  if (verdict < 0) {
    return $records.refused(-verdict, memory[samples_at + 1]);
  }
  if (verdict === $sampling.RESTARTED) {
    memory.fill(0, last_at, last_at + 8);
    memory[last_at] = memory[samples_at + 1];
  }
  const dt = memory[samples_at + 1] - memory[last_at];
  if (verdict === $sampling.MOVED && dt >= memory[settings_at + 4]) {
    advance(memory, 0, memory[samples_at + 5], dt, last_at);
    advance(memory, 1, memory[samples_at + 6], dt, last_at);
    memory[last_at] = memory[samples_at + 1];
    memory[last_at + 7] = dt;
  }
  const velocity = [memory[last_at + 3], memory[last_at + 4]];
  const acceleration = [memory[last_at + 5], memory[last_at + 6]];
  const settled = $sampling.settled(memory, 3, 2 * memory[settings_at + 4], samples_at);
  return $sampling.motion(memory, event, [velocity, acceleration], settled, start, samples_at);
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
