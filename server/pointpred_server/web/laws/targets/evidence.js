// Written by `make page` from evidence.py: change that and run it again.
import { hypot, larger, square } from "../arithmetic.js";
import * as $cursor from "./cursor.js";
import * as $rectangle_mass from "./rectangle_mass.js";
import * as $rectangles from "./rectangles.js";
export const ANGLE = 0.15;
export const ALONG = 0.5;
export const ACROSS = 0.2;
export const LEAST = 0.1;
export function bend(u, g, far2, size) {
  const ux = u[0];
  const uy = u[1];
  const gx = g[0];
  const gy = g[1];
  if (ux === 0 && uy === 0 || far2 === 0) {
    return 0;
  }
  const angle = Math.atan2(ux * gy - uy * gx, ux * gx + uy * gy);
  return Math.log(1 + angle * angle / (ANGLE * ANGLE + 0.0625 * size * size / far2));
}
export function unclaimed(memory, x, y) {
  let gx = x - memory[$cursor.X];
  let gy = y - memory[$cursor.Y];
  const done_x = memory[$cursor.X] - memory[$cursor.X0];
  const done_y = memory[$cursor.Y] - memory[$cursor.Y0];
  const left = hypot(gx, gy);
  const done = hypot(done_x, done_y);
  if (left === 0) {
    gx = done_x;
    gy = done_y;
  }
  const size = hypot(gx, gy);
  const reach = larger(left + LEAST * done, 1);
  const across = square(ACROSS * reach);
  if (size === 0) {
    return [across, 0, across];
  }
  const more = square(ALONG * reach) - across;
  const ux = gx / size;
  const uy = gy / size;
  return [across + more * ux * ux, more * ux * uy, across + more * uy * uy];
}
export function situation(memory) {
  const x = memory[$cursor.X];
  const y = memory[$cursor.Y];
  const way = hypot(x - memory[$cursor.X0], y - memory[$cursor.Y0]);
  const sweep = memory[$cursor.SPEED] * (memory[$cursor.T] - memory[$cursor.T0]);
  const trail_x = x - memory[$cursor.TRAIL_X];
  const trail_y = y - memory[$cursor.TRAIL_Y];
  const vx = memory[$cursor.VX];
  const vy = memory[$cursor.VY];
  return [x, y, trail_x, trail_y, vx, vy, Math.log(larger(way, 1)), Math.log(larger(sweep, 1))];
}
export function feature(row, now, predicted, mass) {
  const x = row[$rectangles.CENTRE_X];
  const y = row[$rectangles.CENTRE_Y];
  const width = row[$rectangles.WIDTH];
  const height = row[$rectangles.HEIGHT];
  const gx = x - now[0];
  const gy = y - now[1];
  const size = 0.5 * (width + height);
  const far2 = gx * gx + gy * gy;
  const left = larger(Math.sqrt(far2), 1);
  const log_left = Math.log(left);
  let inside = 0;
  if (mass) {
    const spread = [predicted[2], predicted[3], predicted[4], predicted[5]];
    inside = $rectangle_mass.log_mass([x - predicted[0], y - predicted[1], width, height], spread);
  }
  return [inside, bend([now[2], now[3]], [gx, gy], far2, size), bend([now[4], now[5]], [gx, gy], far2, size), log_left - now[6], log_left - now[7], Math.log(1 + 2 * left / size)];
}
