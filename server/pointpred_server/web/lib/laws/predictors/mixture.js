// Written by `make laws` from mixture.py: change that and run it again.
import { larger, matrix, remainder, smaller } from "../arithmetic.js";
export const TURN_COS = -0.7373688780783197;
export const TURN_SIN = 0.6754902942615238;
export const HALVINGS = 60;
export const DENSITY_LEAST = 1e-280;
export const LEVELS = [0.5, 0.8];
export const HEAVINESS_LEAST = 1e-06;
export const HEAVINESS_MOST = 40;
export const PROBABILITY_MOST = 0.999999999;
export const LINES = 24;
export const LINES_OF = 120;
export const LINES_LEAST = 3;
export const AT_CENTRE = 0.4;
export const CLOSER = 3;
export const OUTSIDE = 1.0001;
export const POINTS = 2000;
export const POINTS_OF = 10000;
export const POINTS_LEAST = 30;
export const VERTICES = 20000;
export const POLYGONS = 256;
export function squared_radius(share, tail) {
  const normal = -2 * Math.log1p(-share);
  return Number(tail === 0 ? normal : tail * Math.expm1(normal / tail));
}
export function part_density(part, x, y, part_at = 0) {
  const sxx = part[part_at + 3];
  const sxy = part[part_at + 4];
  const syy = part[part_at + 5];
  const tail = part[part_at + 6];
  const determinant = sxx * syy - sxy * sxy;
  const dx = x - part[part_at + 1];
  const dy = y - part[part_at + 2];
  const far = (syy * dx * dx - 2 * sxy * dx * dy + sxx * dy * dy) / determinant;
  const log_density = tail === 0 ? -0.5 * far : -0.5 * (tail + 2) * Math.log1p(far / tail);
  return part[part_at] * Math.exp(log_density) / (2 * Math.PI * Math.sqrt(determinant));
}
export function density(parts, count, x, y) {
  let total = 0;
  for (let k = 0; k < count; k++) {
    total += part_density(parts[k], x, y);
  }
  return total;
}
export function densities(parts, count, points, out) {
  for (let k = 0; k < count; k++) {
    const part_at = 0;
    const wide = Math.sqrt(parts[k][part_at + 3]);
    const slant = parts[k][part_at + 4] / wide;
    const broad = Math.sqrt(parts[k][part_at + 5] - slant * slant);
    let cos = 1;
    let sin = 0;
    for (let i = 0; i < points; i++) {
      const radius = Math.sqrt(squared_radius((i + 0.5) / points, parts[k][part_at + 6]));
      const x = parts[k][part_at + 1] + radius * wide * cos;
      const y = parts[k][part_at + 2] + radius * (slant * cos + broad * sin);
      out[k][i] = density(parts, count, x, y);
      const value_1 = cos * TURN_COS - sin * TURN_SIN;
      const value_2 = cos * TURN_SIN + sin * TURN_COS;
      cos = value_1;
      sin = value_2;
    }
  }
}
export function share_above(parts, count, points, known, threshold) {
  let total = 0;
  for (let k = 0; k < count; k++) {
    let above = 0;
    for (let i = 0; i < points; i++) {
      above += known[k][i] > threshold ? 1 : 0;
    }
    total += parts[k][0] * above / points;
  }
  return total;
}
export function content(parts, count, x, y, points) {
  if (count === 1) {
    const part_at = 0;
    const own = part_density(parts[0], x, y, part_at);
    const best = part_density(parts[0], parts[0][part_at + 1], parts[0][part_at + 2], part_at);
    const power = parts[0][part_at + 6] === 0 ? 1 : parts[0][part_at + 6] / (parts[0][part_at + 6] + 2);
    return 1 - Math.pow(own / best, power);
  }
  const known = matrix(count, points);
  densities(parts, count, points, known);
  return share_above(parts, count, points, known, density(parts, count, x, y));
}
export function threshold_of(parts, count, level, points) {
  if (count === 1) {
    const first_at = 0;
    const far = squared_radius(level, parts[0][first_at + 6]);
    const log_density = parts[0][first_at + 6] === 0 ? -0.5 * far : -0.5 * (parts[0][first_at + 6] + 2) * Math.log1p(far / parts[0][first_at + 6]);
    return part_density(parts[0], parts[0][first_at + 1], parts[0][first_at + 2], first_at) * Math.exp(log_density);
  }
  const known = matrix(count, points);
  densities(parts, count, points, known);
  let most = DENSITY_LEAST;
  for (let k = 0; k < count; k++) {
    const part_at = 0;
    most += part_density(parts[k], parts[k][part_at + 1], parts[k][part_at + 2], part_at);
  }
  let low = Math.log(DENSITY_LEAST);
  let high = Math.log(most);
  for (let _ = 0; _ < HALVINGS; _++) {
    const middle = 0.5 * (low + high);
    if (share_above(parts, count, points, known, Math.exp(middle)) > level) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return Math.exp(0.5 * (low + high));
}
export function squared_radius_over_tail(level, heavy) {
  return Math.exp(-heavy * Math.log(1 - level)) - 1;
}
export function corrected_radius(level, heavy, offset) {
  const lower = Math.exp(smaller(offset, 0));
  return Math.exp(larger(offset, 0)) * (Math.exp(-heavy * Math.log(1 - level) * lower) - 1);
}
export function heaviness(tail) {
  return smaller(larger(2 / tail, HEAVINESS_LEAST), HEAVINESS_MOST);
}
export function corrected_probability(level, tail, near, far) {
  const radius = Math.log(-Math.log(1 - level));
  const half = Math.log(-Math.log(1 - LEVELS[0]));
  const most = Math.log(-Math.log(1 - LEVELS[1]));
  const part = smaller(larger((radius - half) / (most - half), 0), 1);
  const heavy = heaviness(tail);
  let own = corrected_radius(level, heavy, near + part * (far - near));
  if (level > LEVELS[0]) {
    own = larger(own, corrected_radius(LEVELS[0], heavy, near));
  }
  return smaller(1 - Math.exp(-Math.log(1 + own) / heavy), PROBABILITY_MOST);
}
export function reach(part, count, threshold, part_at = 0) {
  const over = part_density(part, part[part_at + 1], part[part_at + 2], part_at) * count / threshold;
  if (!(over > 1)) {
    return -1;
  }
  const tail = part[part_at + 6];
  return Number(tail === 0 ? 2 * Math.log(over) : tail * Math.expm1(2 * Math.log(over) / (tail + 2)));
}
export function lines_of(parts, count, threshold, across, out) {
  let total = 0;
  const lines = larger(smaller(LINES, Math.floor(LINES_OF / count)), LINES_LEAST);
  for (let k = 0; k < count; k++) {
    const part_at = 0;
    let centre = parts[k][part_at + 1];
    let scale = parts[k][part_at + 3];
    if (across === 1) {
      centre = parts[k][part_at + 2];
      scale = parts[k][part_at + 5];
    }
    const far = reach(parts[k], count, threshold, part_at);
    for (let i = 0; i < lines; i++) {
      if (far > 0) {
        let at = 2 * i / (lines - 1) - 1;
        at *= AT_CENTRE + (1 - AT_CENTRE) * at * at;
        const value = centre + OUTSIDE * at * Math.sqrt(far * scale);
        let place = total;
        while (place > 0 && out[place - 1] > value) {
          out[place] = out[place - 1];
          place -= 1;
        }
        out[place] = value;
        total += 1;
      }
    }
  }
  return total;
}
export function height(parts, count, threshold, x, y) {
  return Math.log(larger(density(parts, count, x, y), DENSITY_LEAST)) - Math.log(threshold);
}
export function crossing(parts, count, threshold, one, other) {
  let x0 = one[0];
  let y0 = one[1];
  let h0 = one[2];
  let x1 = other[0];
  let y1 = other[1];
  let h1 = other[2];
  let x = x0;
  let y = y0;
  for (let _ = 0; _ < CLOSER; _++) {
    const part = h0 / (h0 - h1);
    x = x0 + part * (x1 - x0);
    y = y0 + part * (y1 - y0);
    const h = height(parts, count, threshold, x, y);
    if ((h > 0) === (h0 > 0)) {
      x0 = x;
      y0 = y;
      h0 = h;
    } else {
      x1 = x;
      y1 = y;
      h1 = h;
    }
  }
  return [x, y];
}
export function edge_of(side, i, j, columns, rows) {
  if (side === 0) {
    return j * columns + i;
  }
  if (side === 2) {
    return (j + 1) * columns + i;
  }
  return rows * columns + j * columns + (side === 1 ? i + 1 : i);
}
export function partner(sides, side, middle) {
  const way = middle > 0 ? 1 : 3;
  for (let k = 1; k < 4; k++) {
    const other = remainder(side + way * k, 4);
    if (sides[other] === 1) {
      return other;
    }
  }
  return side;
}
export function follow_cells(heights, middles, columns, rows, following) {
  const corners = new Float64Array(4);
  const sides = new Float64Array(4);
  for (let n = 0, end_1 = 2 * columns * rows; n < end_1; n++) {
    following[n] = -1;
  }
  for (let j = 0, end_2 = rows - 1; j < end_2; j++) {
    for (let i = 0, end_3 = columns - 1; i < end_3; i++) {
      corners[0] = heights[j][i];
      corners[1] = heights[j][i + 1];
      corners[2] = heights[j + 1][i + 1];
      corners[3] = heights[j + 1][i];
      for (let side = 0; side < 4; side++) {
        const here = corners[side] > 0;
        const there = corners[remainder(side + 1, 4)] > 0;
        sides[side] = here === there ? 0 : here ? -1 : 1;
      }
      for (let side = 0; side < 4; side++) {
        if (sides[side] === -1) {
          const end = partner(sides, side, middles[j][i]);
          const start = edge_of(side, i, j, columns, rows);
          following[start] = edge_of(end, i, j, columns, rows);
        }
      }
    }
  }
}
export function outlines(parts, count, threshold, points, ends) {
  const xs = new Float64Array(count * LINES);
  const ys = new Float64Array(count * LINES);
  const columns = lines_of(parts, count, threshold, 0, xs);
  const rows = lines_of(parts, count, threshold, 1, ys);
  if (columns === 0 || rows === 0) {
    return 0;
  }
  const heights = matrix(rows, columns);
  const middles = matrix(rows, columns);
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < columns; i++) {
      heights[j][i] = height(parts, count, threshold, xs[i], ys[j]);
    }
  }
  for (let j = 0, end_1 = rows - 1; j < end_1; j++) {
    for (let i = 0, end_2 = columns - 1; i < end_2; i++) {
      middles[j][i] = 0.25 * (heights[j][i] + heights[j][i + 1] + heights[j + 1][i] + heights[j + 1][i + 1]);
    }
  }
  const following = new Float64Array(2 * columns * rows);
  follow_cells(heights, middles, columns, rows, following);
  let total = 0;
  let polygons = 0;
  for (let first = 0, end_3 = 2 * columns * rows; first < end_3; first++) {
    let edge = first;
    const before = total;
    while (following[edge] >= 0 && total < points.length && polygons < ends.length) {
      const upright = edge >= columns * rows;
      const place = upright ? edge - columns * rows : edge;
      const row = Math.floor(place / columns);
      const column = remainder(place, columns);
      const values_4 = upright ? [row + 1, column] : [row, column + 1];
      const below = values_4[0];
      const beside = values_4[1];
      const one = [xs[column], ys[row], heights[row][column]];
      const other = [xs[beside], ys[below], heights[below][beside]];
      const values_5 = crossing(parts, count, threshold, one, other);
      points[total][0] = values_5[0];
      points[total][1] = values_5[1];
      total += 1;
      const after = Math.trunc(following[edge]);
      following[edge] = -1;
      edge = after;
    }
    if (total > before) {
      ends[polygons] = total;
      polygons += 1;
    }
  }
  return polygons;
}
export function points_of(count) {
  return larger(smaller(POINTS, Math.floor(POINTS_OF / count)), POINTS_LEAST);
}
