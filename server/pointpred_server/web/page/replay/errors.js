// The errors along a recorded movement against time, below a slider over the same time.

import { clearCanvas, colours } from "../drawing/canvas.js";
import { line, MARKS, segment } from "../drawing/marks.js";
import { errorAt } from "./picture.js";

/** Margins of the plot, px: the style sheet gives the slider the same, so that both show the same time. */
const [LEFT_PX, RIGHT_PX] = [48, 24];
const [HEAD_PX, FOOT_PX] = [24, 22];
const STEPS = [1, 2, 5];

/** Round numbers from 0 to `most`, about `count` of them. */
function ticks(most, count) {
  const ten = 10 ** Math.floor(Math.log10(most / count));
  const step = [...STEPS, 10].map((one) => one * ten).find((one) => most / one <= count) ?? 10 * ten;
  return Array.from({ length: Math.floor(most / step + 1e-9) + 1 }, (_, i) => i * step);
}

/** The decimals that tell the ticks apart. @param {number[]} ticks */
const decimals = ([, step = 1]) => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));

/** The grid, and the numbers beside it. */
function drawAxes(pen, frame, duration, most) {
  const { left, right, top, foot, x, y } = frame,
    { quiet, line: grid } = colours();
  pen.font = "12px system-ui, sans-serif";
  pen.fillStyle = quiet;
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  for (const mark of ticks(most, 3)) {
    segment(pen, [left, y(mark)], [right, y(mark)], grid, 1);
    pen.fillText(String(mark), left - 6, y(mark));
  }
  const times = ticks(duration, Math.max(2, (right - left) / 70));
  pen.textAlign = "center";
  pen.textBaseline = "alphabetic";
  for (const mark of times) {
    segment(pen, [x(mark), top], [x(mark), foot], grid, 1);
    pen.fillText(`${mark.toFixed(decimals(times))} s`, x(mark), foot + 16);
  }
  pen.textAlign = "left";
  pen.fillText("error, px", 8, 15);
}

/** Draws the errors of the predictors and of no prediction against time, with a line at the time `now`, s. */
export function drawErrors(canvas, movement, columns, now) {
  const { pen, width, height } = clearCanvas(canvas);
  const { none, past, ...markColours } = colours();
  const duration = movement.t[movement.t.length - 1] || 1;
  const errorsOf = (column) => movement.t.map((_, k) => errorAt(movement, column, k));
  const hold = errorsOf(movement);
  const predicted = columns.map((column) => (column === null ? [] : errorsOf(column)));
  const holdMost = hold.reduce((most, value) => Math.max(most, value), 1);
  const largest = predicted.flat().reduce((most, value) => Math.max(most, value ?? 0), holdMost);
  const most = Math.min(1.5 * holdMost, 1.05 * largest); // much larger errors leave the picture
  const [left, right, top, foot] = [LEFT_PX, width - RIGHT_PX, HEAD_PX, height - FOOT_PX];
  const x = (t) => left + (t / duration) * (right - left),
    y = (value) => foot - (value / most) * (foot - top);
  drawAxes(pen, { left, right, top, foot, x, y }, duration, most);
  pen.save();
  pen.beginPath();
  pen.rect(left - 2, top - 2, right - left + 4, foot - top + 4);
  pen.clip();
  const stroke = (values, colour, dash = []) =>
    line(
      pen,
      values.flatMap((value, k) => (value === null ? [] : [[x(movement.t[k]), y(value)]])),
      colour,
      2,
      dash,
    );
  stroke(hold, none);
  predicted.forEach((values, which) => stroke(values, markColours[MARKS[which].colour], MARKS[which].outline));
  segment(pen, [x(now), top], [x(now), foot], past, 2);
  pen.restore();
  canvas.dataset.now = String(x(now));
}
