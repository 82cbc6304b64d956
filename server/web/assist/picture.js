// The field of the assist view: the target, the cursor that the service moves, and what it predicts.

import { disc, inks, line, prepare } from "../drawing/canvas.js";

const ARM = 9;

/** Draws it; `prediction` may be null, `helps` says that help moved the cursor just now. */
export function drawAssist(canvas, { cursor, target, prediction, helps, held }) {
  const { pen } = prepare(canvas);
  const ink = inks();
  if (target !== null) disc(pen, [target.x, target.y], target.width / 2, ink.target, held);
  if (prediction !== null && held) disc(pen, prediction, 9, ink.endpoint);
  if (cursor === null) return;
  const [x, y] = cursor, colour = held ? ink.text : ink.quiet;
  line(pen, [[x - ARM, y], [x + ARM, y]], colour, 2);
  line(pen, [[x, y - ARM], [x, y + ARM]], colour, 2);
  if (helps) disc(pen, cursor, ARM + 3, ink.past, false, 2);
}
