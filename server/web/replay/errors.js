// The errors along one recorded movement against time, above a slider over the same time.

import { MARKS, inks, line, prepare } from "../drawing/canvas.js";
import { errorAt } from "./picture.js";

/** Room beside the picture, px: the slider above it keeps the same, so that both stand at the same time. */
const [LEFT_PX, RIGHT_PX] = [48, 24];
const [HEAD_PX, FOOT_PX] = [24, 22];
const STEPS = [1, 2, 5];

/** Round numbers from 0 up to `most`, about `count` of them. */
export function ticks(most, count) {
  const ten = 10 ** Math.floor(Math.log10(most / count));
  const step = [...STEPS, 10].map((one) => one * ten).find((one) => most / one <= count) ?? 10 * ten;
  return Array.from({ length: Math.floor(most / step + 1e-9) + 1 }, (_, i) => i * step);
}

/** Decimals that tell the ticks apart. */
const decimals = ([, step = 1]) => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));

/** Numbered lines of both axes; the numbers stand outside the frame, where no line strikes them. */
function drawAxes(pen, frame, end, most, ink) {
  const { left, right, top, foot, x, y } = frame;
  pen.font = "12px system-ui, sans-serif";
  pen.fillStyle = ink.quiet;
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  for (const mark of ticks(most, 3)) {
    line(pen, [[left, y(mark)], [right, y(mark)]], ink.line, 1);
    pen.fillText(String(mark), left - 6, y(mark));
  }
  const times = ticks(end, Math.max(2, (right - left) / 70));
  pen.textAlign = "center";
  pen.textBaseline = "alphabetic";
  for (const mark of times) {
    line(pen, [[x(mark), top], [x(mark), foot]], ink.line, 1);
    pen.fillText(`${mark.toFixed(decimals(times))} s`, x(mark), foot + 16);
  }
  pen.textAlign = "left";
  pen.fillText("error, px", 8, 15);
}

/** The errors of the predictions and of no prediction against time, with a line at the time `now`, s. */
export function drawErrors(canvas, movement, columns, now) {
  const { pen, width, height } = prepare(canvas);
  const ink = inks();
  const end = movement.t[movement.t.length - 1] || 1;
  const errors = (column) => movement.t.map((_, k) => errorAt(movement, column, k));
  const floor = errors(movement);
  const own = columns.map((column) => (column === null ? [] : errors(column)));
  const usual = floor.reduce((most, value) => Math.max(most, value), 1);
  const largest = own.flat().reduce((most, value) => Math.max(most, value ?? 0), usual);
  const most = Math.min(1.5 * usual, 1.05 * largest); // what is far off leaves the picture
  const [left, right, top, foot] = [LEFT_PX, width - RIGHT_PX, HEAD_PX, height - FOOT_PX];
  const x = (t) => left + (t / end) * (right - left), y = (value) => foot - (value / most) * (foot - top);
  drawAxes(pen, { left, right, top, foot, x, y }, end, most, ink);
  pen.save();
  pen.beginPath();
  pen.rect(left - 2, top - 2, right - left + 4, foot - top + 4);
  pen.clip();
  const stroke = (values, colour, dash = []) => line(pen, values.flatMap((value, k) => (value === null ? [] : [[x(movement.t[k]), y(value)]])), colour, 2, dash);
  stroke(floor, ink.none);
  own.forEach((values, which) => stroke(values, ink[MARKS[which].colour], which ? [6, 4] : []));
  line(pen, [[x(now), top], [x(now), foot]], ink.past, 2);
  pen.restore();
  canvas.dataset.now = String(x(now));
}
