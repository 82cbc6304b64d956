// Written by `make laws` from submovements.py: change that and run it again.
export const FALLEN = 0.7;
export const RISEN = 1.4;
export const RISE_SHARE = 0.02;
export const RISE_M_S = 0.005;
export const REST_M_S = 1e-06;
export function divide(s, point, speed, movement_peak, s_at = 0) {
  if (s[s_at + 7] === 0) {
    if (speed > s[s_at + 5]) {
      s[s_at + 5] = speed;
      s[s_at + 6] = point[0];
    } else if (speed < FALLEN * s[s_at + 5]) {
      s[s_at + 7] = 1;
      s[s_at + 8] = 2 * speed;
    }
  }
  if (s[s_at + 7] === 0) {
    return;
  }
  if (speed < s[s_at + 8] - REST_M_S) {
    s[s_at + 8] = speed;
    s[s_at + 9] = point[0];
    s[s_at + 10] = point[1];
    s[s_at + 11] = point[2];
    s[s_at + 12] = point[3];
  } else if (speed > RISEN * s[s_at + 8] + RISE_SHARE * movement_peak + RISE_M_S) {
    s[s_at + 7] = 0;
    s[s_at] += 1;
    const value_1 = s[s_at + 9];
    const value_2 = s[s_at + 12];
    s[s_at + 1] = value_1;
    s[s_at + 4] = value_2;
    const value_3 = s[s_at + 10];
    const value_4 = s[s_at + 11];
    s[s_at + 2] = value_3;
    s[s_at + 3] = value_4;
    s[s_at + 5] = speed;
    s[s_at + 6] = point[0];
  }
}
