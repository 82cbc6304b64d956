// Written by `make page` from fused_path.py: change that and run it again.
import { larger, smaller } from "../arithmetic.js";
import * as $delay from "../regression/delay.js";
export const POSITION = 0;
export const VELOCITY = 1;
export const OFFSET = 2;
export const WEIGHT = 3;
export const AXIS = 6;
export const SECOND = 6;
export const DELAY = 12;
export const SIZE = 13;
export const DELAY_MOST_S = 0.02;
export const SPACING_S = 0.0003125;
export const RING = 68;
export const INTEGRALS = 6;
export const STATE = 0;
export const COVARIANCE = 13;
export const FORCE = 182;
export const FIRST = 185;
export const TWICE = 188;
export const PAST = 191;
export const LENGTH = 669;
export function remember(memory, at, t) {
  const place = $delay.push(memory, at + PAST, INTEGRALS, RING, SPACING_S, t);
  for (let i = 0; i < INTEGRALS; i++) {
    memory[place + i] = memory[at + FIRST + i];
  }
}
export function acceleration(memory, at, axis, force) {
  const x = at + STATE + axis;
  let total = memory[x + OFFSET];
  for (let i = 0; i < 3; i++) {
    total += memory[x + WEIGHT + i] * memory[force + i];
  }
  return total;
}
export function carry(memory, row, stride, at, dt) {
  let push = memory[row + OFFSET * stride];
  for (let i = 0; i < 3; i++) {
    push += memory[row + (WEIGHT + i) * stride] * memory[at + FORCE + i];
  }
  memory[row] += dt * (memory[row + stride] + 0.5 * dt * push);
  memory[row + stride] += dt * push;
}
export function predict(memory, at, density, drift, dt) {
  let axis;
  const p = at + COVARIANCE;
  for (let number = 0; number < 2; number++) {
    axis = number * AXIS;
    carry(memory, at + STATE + axis, 1, at, dt);
    for (let j = 0; j < SIZE; j++) {
      carry(memory, p + axis * SIZE + j, SIZE, at, dt);
    }
  }
  for (let number = 0; number < 2; number++) {
    axis = number * AXIS;
    for (let i = 0; i < SIZE; i++) {
      carry(memory, p + i * SIZE + axis, 1, at, dt);
    }
  }
  for (let number = 0; number < 2; number++) {
    axis = number * AXIS;
    const row = p + axis * (SIZE + 1);
    const q = drift * dt;
    const s = density * dt;
    const both = q * Math.pow(dt, 3) / 8 + 0.5 * s * dt;
    memory[row] += q * Math.pow(dt, 4) / 20 + s * dt * dt / 3;
    memory[row + VELOCITY] += both;
    memory[row + VELOCITY * SIZE] += both;
    memory[row + OFFSET] += q * dt * dt / 6;
    memory[row + OFFSET * SIZE] += q * dt * dt / 6;
    memory[row + VELOCITY * (SIZE + 1)] += q * dt * dt / 3 + s;
    memory[row + VELOCITY * SIZE + OFFSET] += 0.5 * q * dt;
    memory[row + OFFSET * SIZE + VELOCITY] += 0.5 * q * dt;
    memory[row + OFFSET * (SIZE + 1)] += q;
  }
  for (let i = 0; i < 3; i++) {
    const force = memory[at + FORCE + i];
    const first = memory[at + FIRST + i];
    memory[at + TWICE + i] += dt * (first + 0.5 * dt * force);
    memory[at + FIRST + i] = first + dt * force;
  }
}
export function correct(memory, at, h, error, noise) {
  const p = at + COVARIANCE;
  const spread = new Float64Array(SIZE);
  let total = noise;
  for (let i = 0; i < SIZE; i++) {
    for (let j = 0; j < SIZE; j++) {
      spread[i] += memory[p + i * SIZE + j] * h[j];
    }
    total += h[i] * spread[i];
  }
  for (let i = 0; i < SIZE; i++) {
    const share = spread[i] / total;
    memory[at + STATE + i] += share * error;
    for (let j = 0; j < SIZE; j++) {
      memory[p + i * SIZE + j] -= share * spread[j];
    }
    memory[p + i * (SIZE + 1)] = larger(memory[p + i * (SIZE + 1)], 0);
  }
  const late = memory[at + STATE + DELAY];
  memory[at + STATE + DELAY] = smaller(larger(late, -DELAY_MOST_S), DELAY_MOST_S);
  return Math.abs(error) / Math.sqrt(total);
}
export function measure(memory, at, axis, now, ahead, place, noise) {
  const x = at + STATE + axis;
  const d = memory[at + STATE + DELAY] + ahead;
  const h = new Float64Array(SIZE);
  const values_1 = $delay.find(memory, at + PAST, INTEGRALS, RING, now - larger(d, 0));
  const known = values_1[0];
  const before = values_1[1];
  const after = values_1[2];
  const share = values_1[3];
  h[axis + POSITION] = 1;
  h[axis + VELOCITY] = -d;
  h[axis + OFFSET] = 0.5 * d * d;
  let slope = memory[x + VELOCITY] - d * memory[x + OFFSET];
  for (let i = 0; i < 3; i++) {
    let way = 0.5 * d * d * memory[at + FORCE + i];
    let first = d * memory[at + FORCE + i];
    if (d > 0 && known) {
      const then = memory[before + i] + share * (memory[after + i] - memory[before + i]);
      const twice = memory[before + 3 + i] + share * (memory[after + 3 + i] - memory[before + 3 + i]);
      way = d * memory[at + FIRST + i] - memory[at + TWICE + i] + twice;
      first = memory[at + FIRST + i] - then;
    }
    h[axis + WEIGHT + i] = way;
    slope -= memory[x + WEIGHT + i] * first;
  }
  let error = place;
  for (let i = 0; i < AXIS; i++) {
    error -= h[axis + i] * memory[x + i];
  }
  h[DELAY] = -slope;
  return correct(memory, at, h, error, noise);
}
export function acceleration_variance(memory, at, axis, force) {
  const row = at + COVARIANCE + (axis + OFFSET) * SIZE + axis;
  let most = 0;
  for (let i = 0; i < 2; i++) {
    const own = memory[at + COVARIANCE + (axis + WEIGHT + i) * (SIZE + 1)];
    const both = 2 * force * Math.abs(memory[row + WEIGHT + i]);
    most = larger(most, memory[row + OFFSET] + both + force * force * own);
  }
  return most;
}
export function forget(memory, at, i, variance) {
  const p = at + COVARIANCE;
  for (let j = 0; j < SIZE; j++) {
    memory[p + i * SIZE + j] = memory[p + j * SIZE + i] = 0;
  }
  memory[p + i * (SIZE + 1)] = variance;
}
