// Written by `make page` from submovement.py: change that and run it again.
export const PEAK = 0;
export const PEAK_X = 1;
export const PEAK_Y = 2;
export const VALLEY = 3;
export const VALLEY_X = 4;
export const VALLEY_Y = 5;
export const START_X = 6;
export const START_Y = 7;
export function begin(memory, at, x, y) {
  memory[at + PEAK] = 0;
  memory[at + VALLEY] = 0;
  memory[at + PEAK_X] = x;
  memory[at + PEAK_Y] = y;
  memory[at + VALLEY_X] = x;
  memory[at + VALLEY_Y] = y;
  memory[at + START_X] = x;
  memory[at + START_Y] = y;
}
export function follow(memory, at, rise, x, y, speed) {
  const peak = memory[at + PEAK];
  const valley = memory[at + VALLEY];
  if (speed < peak && speed <= valley + rise * peak) {
    if (speed <= valley) {
      memory[at + VALLEY] = speed;
      memory[at + VALLEY_X] = x;
      memory[at + VALLEY_Y] = y;
    }
    return;
  }
  if (speed < peak) {
    const value_1 = memory[at + VALLEY_X];
    const value_2 = memory[at + VALLEY_Y];
    memory[at + START_X] = value_1;
    memory[at + START_Y] = value_2;
  }
  memory[at + PEAK] = speed;
  memory[at + VALLEY] = speed;
  memory[at + PEAK_X] = x;
  memory[at + PEAK_Y] = y;
  memory[at + VALLEY_X] = x;
  memory[at + VALLEY_Y] = y;
}
