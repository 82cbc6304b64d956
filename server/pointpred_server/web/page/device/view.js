// The attached device in the live view: its trail, predictions, rates, losses and gain curve.

import { clearCanvas, FrameLoop, prefersLessMotion } from "../drawing/canvas.js";
import { drawLegends } from "../drawing/legend.js";
import { SmoothRegions } from "../drawing/regions.js";
import { drawLive, recentPart } from "../live/picture.js";
import { markOf, opacityAfter, PredictionFields, publishDrawn, publishRegions } from "../live/prediction.js";
import { cellsOf, part, sentence, write } from "../shell/elements.js";
import { number, percent } from "../shell/numbers.js";
import { Camera } from "./camera.js";
import { GainCurve } from "./gain-curve.js";
import { attachedDevice, DeviceStream } from "./stream.js";

const THIN_S = 0.004; // the trail needs no more points, however fast the device is
const MOST_POINTS = 2000;
const NUMBERS_MS = 120;
const NO_TILES = { list: [], opacities: {}, proposed: null };
const LOSSES = { lost: "lost", unreadable: "unreadable", refused: "refused", resynchronised: "gaps in the kernel" };

const canvas = /** @type {HTMLCanvasElement} */ (part("device-scene"));
const status = part("device-status");
const link = part("device-link");
const cells = cellsOf(part("live-device"));
const fields = new PredictionFields(part("live-device"));
const loop = new FrameLoop(frame);

/** @type {DeviceStream|null} */ let stream = null;
/** @type {GainCurve|null} */ let curve = null;
let camera = new Camera();
let active = false; // whether the view is open
let trail = [];
/** @type {[import("../service/predictor-connection.js").Prediction, number]|null} */ let newest = null; // and when, ms
let regions = new SmoothRegions(); // in px of the device's plane
let clockOffset = 0; // s from the page's clock to the device's
let writeAt = 0;

/** @param {string} text @param {"none"|"attached"|"unplugged"|"error"|"closed"|"waiting"} state */
function showStatus(text, state) {
  write(status, text);
  status.dataset.state = state;
}

const handlers = {
  device: (message) => {
    [trail, newest, camera, regions] = [[], null, new Camera(), new SmoothRegions()];
    const resolution = message.cpi === null ? "Its resolution is unknown." : `${number(message.cpi)} counts per inch.`;
    write(part("device-name"), message.name);
    write(
      part("device-description"),
      `${sentence(message.words)} Predictor: ${message.predictor}. ${resolution} Times: ${message.clock}.`,
    );
    showStatus("Attached.", "attached");
  },
  events: ({ events }) => {
    clockOffset = events[events.length - 1][0] - performance.now() / 1000;
    for (const [t, x, y] of events) {
      if (trail.length > 1 && t - trail[trail.length - 2][0] < THIN_S) trail.pop();
      trail.push([t, x, y]);
    }
    trail.splice(0, trail.length - MOST_POINTS); // a hidden page draws no frames, which would shorten it
    canvas.dataset.events = String(Number(canvas.dataset.events ?? 0) + events.length);
  },
  prediction: (message) => {
    newest = [message, performance.now()];
  },
  status: (message) => {
    write(cells.rate, number(message.rate_hz, 0, "/s"));
    write(cells.delay, number(message.delay_p99_s === null ? null : 1000 * message.delay_p99_s, 2, "ms"));
    write(cells.reports, number(message.reports));
    const losses = Object.entries(LOSSES)
      .filter(([name]) => message[name] > 0)
      .map(([name, noun]) => `${message[name]} ${noun}`);
    write(cells.losses, losses.join(", ") || "none");
    cells.losses.title = cells.losses.textContent;
    if (message.plugged) showStatus(message.note === null ? "Attached." : sentence(message.note), "attached");
    else showStatus("Unplugged: waiting for the device to come back.", "unplugged");
  },
  transfer: ({ curve: measured, words }) => {
    if (measured !== null) curve?.show(measured);
    write(part("device-gain-summary"), measured === null ? sentence(words) : gainSummary(measured));
  },
  error: ({ message }) => showStatus(sentence(message), "error"),
  bye: ({ reason }) => showStatus(`The service has closed the connection: ${reason}.`, "closed"),
  state: (state) => state === "waiting" && showStatus("The service does not answer. Trying again…", "waiting"),
};

function gainSummary({ words, compared, closest, edges }) {
  const errors = compared.map(({ kind, largest }) => `${kind} off by ${percent(largest, 1)} at most`).join(", ");
  const omitted = edges > 0 ? ` ${edges} events at the edge of the screen were left out.` : "";
  return `${sentence(words)}${errors && ` Compared with the measured gains: ${errors}.`}${closest ? ` Closest: ${closest}.` : ""}${omitted}`;
}

function frame(now) {
  const seconds = performance.now() / 1000 + clockOffset;
  trail = recentPart(trail, seconds);
  const mark = currentMark(now);
  if (trail.length > 0) draw(seconds, mark);
  else clearCanvas(canvas);
  publishRegions(canvas, [mark]);
  fields.writeRegion(mark, canvas, camera.scale);
  if (now <= writeAt) return;
  writeAt = now + (prefersLessMotion() ? 5 : 1) * NUMBERS_MS;
  fields.writeTimes(mark);
}

/** The newest prediction as it is drawn, in px of the device's plane. */
function currentMark(now) {
  const [prediction, at] = newest !== null && stream?.state === "open" ? newest : [null, -Infinity];
  return markOf(prediction, regions, now, opacityAfter(performance.now() - at));
}

function draw(seconds, mark) {
  const points = trail.map(([, x, y]) => [x, y]);
  camera.follow(
    mark === null ? points : [...points, [mark.prediction.x, mark.prediction.y]],
    canvas.clientWidth,
    canvas.clientHeight,
  );
  const projected = trail.map(([t, x, y]) => [t, ...camera.place([x, y])]);
  publishDrawn(canvas, drawLive(canvas, projected, [mark && camera.project(mark)], seconds, NO_TILES));
}

/** Looks for a device, and shows it while the view is open. */
export async function open() {
  active = true;
  const { attached, message } = await attachedDevice();
  if (!active || stream !== null) return;
  if (attached === null) {
    showStatus(sentence(message), "none");
    return;
  }
  handlers.device(attached); // before it becomes visible, so that nothing moves afterwards
  link.classList.remove("away");
  part("device-view").hidden = false;
  drawLegends();
  curve ??= new GainCurve(part("device-gain"));
  curve.fit();
  stream = new DeviceStream(handlers);
  loop.start();
}

/** Closes the connection. */
export function close() {
  active = false;
  loop.stop();
  stream?.close();
  stream = null;
}

link.addEventListener("click", () => {
  part("live-device-title").scrollIntoView({ behavior: prefersLessMotion() ? "auto" : "smooth" });
  part("live-device-title").focus({ preventScroll: true });
});
