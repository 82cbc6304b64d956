// Two drawings of one replayed movement: the scene on the screen, and the errors against time.

const MARGIN_PX = 22;

/** The distance from a predicted point to where the movement ended, px; null where nothing was predicted. */
export function errorAt(movement, column, i) {
  const last = movement.x.length - 1;
  const x = column.x[i], y = column.y[i];
  return x === null ? null : Math.hypot(x - movement.x[last], y - movement.y[last]);
}

/** A canvas in CSS pixels, sharp on any display, cleared. */
function prepare(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = canvas.clientWidth, height = canvas.clientHeight;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const pen = canvas.getContext("2d");
  pen.scale(ratio, ratio);
  pen.lineJoin = pen.lineCap = "round";
  return { pen, width, height };
}

function colours() {
  const style = getComputedStyle(document.documentElement);
  const names = ["past", "future", "endpoint", "none", "target", "line", "quiet"];
  return Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

/** Screen px of the movement to px of the canvas: one scale for both axes, the trail and the target inside. */
function projection(movement, width, height) {
  const { target } = movement;
  const reach = target === null ? 0 : (target.width || 0) / 2;
  const xs = target === null ? movement.x : [...movement.x, target.x - reach, target.x + reach];
  const ys = target === null ? movement.y : [...movement.y, target.y - reach, target.y + reach];
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const [top, bottom] = [Math.min(...ys), Math.max(...ys)];
  const room = 0.25 * Math.max(right - left, bottom - top, 1);
  const scale = Math.min(
    (width - 2 * MARGIN_PX) / (right - left + 2 * room),
    (height - 2 * MARGIN_PX) / (bottom - top + 0.6 * room),
  );
  const place = (x, y) => [width / 2 + scale * (x - (left + right) / 2), height / 2 + scale * (y - (top + bottom) / 2)];
  return { place, scale };
}

function line(pen, points, colour, width) {
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.beginPath();
  points.forEach(([x, y], i) => (i === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
  pen.stroke();
}

function disc(pen, [x, y], radius, colour, filled) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.strokeStyle = pen.fillStyle = colour;
  pen.lineWidth = 2;
  if (filled) pen.fill();
  else pen.stroke();
}

/** The trail so far and to come, the target, the cursor and the predicted endpoint at event `i`. */
export function drawScene(canvas, movement, column, i) {
  const { pen, width, height } = prepare(canvas);
  const ink = colours();
  const { place, scale } = projection(movement, width, height);
  const trail = movement.x.map((x, k) => place(x, movement.y[k]));
  if (movement.target !== null) {
    const { target } = movement;
    disc(pen, place(target.x, target.y), Math.max(4, (scale * (target.width || 0)) / 2), ink.target, false);
  }
  line(pen, trail.slice(i), ink.future, 2);
  line(pen, trail.slice(0, i + 1), ink.past, 3);
  disc(pen, trail[i], 5, ink.none, true);
  if (column.x[i] === null) return;
  const [x, y] = place(column.x[i], column.y[i]);
  const inside = [Math.min(width - 9, Math.max(9, x)), Math.min(height - 9, Math.max(9, y))]; // beyond: at the edge
  pen.setLineDash([4, 5]);
  line(pen, [trail[i], inside], ink.endpoint, 1.5);
  pen.setLineDash([]);
  disc(pen, inside, 7, ink.endpoint, false);
}

/** The error of the prediction and of no prediction against time, with a line at event `i`. */
export function drawErrors(canvas, movement, column, none, i) {
  const { pen, width, height } = prepare(canvas);
  const ink = colours();
  const end = movement.t[movement.t.length - 1] || 1;
  const own = movement.t.map((_, k) => errorAt(movement, column, k));
  const floor = movement.t.map((_, k) => errorAt(movement, none, k));
  const usual = Math.max(1, ...floor);
  const most = Math.min(1.5 * usual, Math.max(1.05 * usual, ...own)); // what is far off leaves the picture
  const at = (k, value) => [
    MARGIN_PX + (movement.t[k] / end) * (width - 2 * MARGIN_PX),
    height - 20 - (Math.min(value, most) / most) * (height - 40),
  ];
  line(pen, [[MARGIN_PX, height - 20], [width - MARGIN_PX, height - 20]], ink.line, 1);
  line(pen, floor.map((value, k) => at(k, value)), ink.none, 2);
  line(pen, own.flatMap((value, k) => (value === null ? [] : [at(k, value)])), ink.endpoint, 2);
  line(pen, [[at(i, 0)[0], 20], [at(i, 0)[0], height - 20]], ink.past, 1);
  pen.fillStyle = ink.quiet;
  pen.font = "12px system-ui, sans-serif";
  pen.fillText(`error, px (full height ${most.toFixed(0)})`, MARGIN_PX, 14);
  pen.textAlign = "right";
  pen.fillText(`${end.toFixed(2)} s`, width - MARGIN_PX, height - 5);
}
