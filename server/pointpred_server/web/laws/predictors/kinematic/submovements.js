// Written by `make laws` from submovements.py: change that and run it again.
export const FALLEN = 0.7;
export const RISEN = 1.4;
export const RISE_SHARE = 0.02;
export const RISE_M_S = 0.005;
export const REST_M_S = 1e-06;
export const COUNT = 0;
export const T = 1;
export const X = 2;
export const Y = 3;
export const PATH = 4;
export const PEAK = 5;
export const PEAK_T = 6;
export const FALLING = 7;
export const LOW = 8;
export const LOW_T = 9;
export const LOW_X = 10;
export const LOW_Y = 11;
export const LOW_PATH = 12;
export function divide(memory, at, point, speed, movement_peak) {
  if (memory[at + FALLING] === 0) {
    if (speed > memory[at + PEAK]) {
      memory[at + PEAK] = speed;
      memory[at + PEAK_T] = point[0];
    } else if (speed < FALLEN * memory[at + PEAK]) {
      memory[at + FALLING] = 1;
      memory[at + LOW] = 2 * speed;
    }
  }
  if (memory[at + FALLING] === 0) {
    return;
  }
  if (speed < memory[at + LOW] - REST_M_S) {
    memory[at + LOW] = speed;
    memory[at + LOW_T] = point[0];
    memory[at + LOW_X] = point[1];
    memory[at + LOW_Y] = point[2];
    memory[at + LOW_PATH] = point[3];
  } else if (speed > RISEN * memory[at + LOW] + RISE_SHARE * movement_peak + RISE_M_S) {
    memory[at + FALLING] = 0;
    memory[at + COUNT] += 1;
    const value_1 = memory[at + LOW_T];
    const value_2 = memory[at + LOW_PATH];
    memory[at + T] = value_1;
    memory[at + PATH] = value_2;
    const value_3 = memory[at + LOW_X];
    const value_4 = memory[at + LOW_Y];
    memory[at + X] = value_3;
    memory[at + Y] = value_4;
    memory[at + PEAK] = speed;
    memory[at + PEAK_T] = point[0];
  }
}
