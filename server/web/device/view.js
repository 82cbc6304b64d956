// The attached device in the live view: its way, where it is predicted to end, rates, losses, and the gain curve.

import { Camera } from "./camera.js";
import { DeviceStream, attached } from "./stream.js";
import { calm } from "../drawing/canvas.js";
import { drawLive, drawNothing } from "../live/picture.js";
import { number, part, percent, write } from "../page/elements.js";
import { GainCurve } from "./gain-curve.js";
import { markOf, opacityAfter, sizeOf } from "../live/card.js";
import { CalmRegions } from "../drawing/regions.js";

const TRAIL_S = 2;
const THIN_S = 0.004; // a trail needs no more points than that, however fast the device is
const MOST_POINTS = 2000;
const NUMBERS_MS = 120;
const NO_TILES = { list: [], shares: {}, proposed: null };
const LOSSES = { lost: "lost", unreadable: "unreadable", refused: "refused", resynchronised: "gaps in the kernel" };

const canvas = part("device-scene");
const said = part("device-said");
const go = part("device-go");
const of = Object.fromEntries([...part("live-device").querySelectorAll("[data-of]")].map((cell) => [cell.dataset.of, cell]));

let stream = null;
let curve = null;
let camera = new Camera();
let wanted = false; // whether the view is open
let drawing = false; // one loop, however often it is opened
let device = null;
let trail = [];
let newest = null; // [prediction, ms]
let regions = new CalmRegions(); // in px of the device's plane
let offset = 0; // s from the page's clock to the device's
let tellAt = 0;

const told = {
  device: (message) => {
    device = message;
    [trail, newest, camera, regions] = [[], null, new Camera(), new CalmRegions()];
    write(part("device-name"), message.name);
    write(part("device-words"), `${sentence(message.words)} Predictor: ${message.predictor}. ${resolution(message.cpi)} Times: ${message.clock}.`);
    say("Attached.");
  },
  events: ({ events }) => {
    offset = events[events.length - 1][0] - performance.now() / 1000;
    for (const [t, x, y] of events) {
      if (trail.length > 1 && t - trail[trail.length - 2][0] < THIN_S) trail.pop();
      trail.push([t, x, y]);
    }
    trail.splice(0, trail.length - MOST_POINTS); // nothing else shortens it while the page is hidden
    canvas.dataset.events = Number(canvas.dataset.events ?? 0) + events.length;
  },
  prediction: (message) => {
    newest = [message, performance.now()];
  },
  status: (message) => {
    write(of.rate, number(message.rate_hz, 0, "/s"));
    write(of.delay, number(message.delay_p99_s === null ? null : 1000 * message.delay_p99_s, 2, "ms"));
    write(of.reports, number(message.reports));
    const losses = Object.entries(LOSSES).filter(([name]) => message[name] > 0).map(([name, words]) => `${message[name]} ${words}`);
    write(of.losses, losses.join(", ") || "none");
    of.losses.title = of.losses.textContent;
    const attached = message.note === null ? "Attached." : sentence(message.note);
    say(message.plugged ? attached : "Unplugged: waiting for it to come back.");
  },
  transfer: (message) => {
    if (message.curve !== null) curve.show(message.curve);
    write(part("device-gain-said"), message.curve === null ? sentence(message.words) : gains(message.curve));
  },
  error: (message) => say(sentence(message.message)),
  bye: ({ reason }) => say(`The service has closed the connection: ${reason}.`),
  state: (state) => state === "waiting" && say("The service does not answer. Trying again…"),
};

const sentence = (words) => `${words.charAt(0).toUpperCase()}${words.slice(1)}.`;
const resolution = (cpi) => (cpi === null ? "Its resolution is not known." : `${number(cpi)} counts per inch.`);

function gains({ words, compared, closest, edges }) {
  const each = compared.map(({ kind, largest }) => `${kind} off by ${percent(largest, 1)} at most`).join(", ");
  const left = edges > 0 ? ` ${edges} events at the screen's edge left out.` : "";
  return `${sentence(words)}${each && ` Against what was measured: ${each}.`}${closest ? ` Closest: ${closest}.` : ""}${left}`;
}

function say(words) {
  write(said, words);
}

function frame(now) {
  drawing = stream !== null;
  if (!drawing) return;
  const seconds = performance.now() / 1000 + offset;
  trail = trail.slice(Math.max(0, trail.findIndex(([t]) => t > seconds - TRAIL_S)));
  const shown = mark(now);
  if (trail.length > 0) show(seconds, shown);
  else drawNothing(canvas);
  canvas.dataset.regions = JSON.stringify([shown && { ...shown.regions, opacity: shown.opacity }]);
  of.region.dataset.px = shown?.regions ? `${2 * shown.regions.inner.major} ${2 * shown.regions.inner.minor}` : "";
  write(of.region, shown === null ? "–" : sizeOf(shown, canvas, camera.scale));
  if (now > tellAt) tell(now, shown);
  requestAnimationFrame(frame);
}

/** What is to be drawn of the newest prediction, in px of the device's plane. */
function mark(now) {
  const lives = newest !== null && stream.state === "open";
  return markOf(lives ? newest[0] : null, regions, now, lives ? opacityAfter(performance.now() - newest[1]) : 0);
}

function show(seconds, shown) {
  const points = trail.map(([, x, y]) => [x, y]);
  camera.follow(shown === null ? points : [...points, [shown.prediction.x, shown.prediction.y]], canvas.clientWidth, canvas.clientHeight);
  const placed = trail.map(([t, x, y]) => [t, ...camera.place([x, y])]);
  const drawn = drawLive(canvas, placed, [shown && camera.view(shown)], seconds, NO_TILES);
  canvas.dataset.drawn = Number(canvas.dataset.drawn ?? 0) + drawn;
}

function tell(now, shown) {
  tellAt = now + (calm() ? 5 : 1) * NUMBERS_MS;
  write(of.phase, shown?.prediction.phase ?? "–");
  write(of.left, number(shown?.prediction.remaining_s, 2, "s"));
}

/** Looks for a device, and shows it while the view is open. */
export async function open() {
  wanted = true;
  const found = await attached();
  if (!wanted || stream !== null) return;
  if (found.attached === null) {
    say(sentence(found.message));
    return;
  }
  told.device(found.attached); // before it is seen, so that nothing moves afterwards
  go.classList.remove("away");
  part("device-shown").hidden = false;
  curve ??= new GainCurve(part("device-gain"));
  curve.fit();
  stream = new DeviceStream(told);
  if (!drawing) requestAnimationFrame(frame);
  drawing = true;
}

/** Lets the connection go. */
export function close() {
  wanted = false;
  stream?.close();
  stream = null;
}

go.addEventListener("click", () => {
  part("live-device-title").scrollIntoView({ behavior: calm() ? "auto" : "smooth" });
  part("live-device-title").focus({ preventScroll: true });
});
