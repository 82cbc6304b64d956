// The live view: your own pointer, and where each predictor says that its movement will end.

import { calm } from "./draw.js";
import { drawDemo, drawLive, drawNothing } from "./draw-live.js";
import { number, offer, part, write } from "./elements.js";
import * as device from "./live-device.js";
import { Demo } from "./live-demo.js";
import { Movement, speed } from "./live-movement.js";
import { LiveCard } from "./live-card.js";
import { follow } from "./pointer.js";
import { PREFERRED, predictors } from "./service.js";
import { Strip } from "./strip.js";
import { Tiles } from "./live-tiles.js";

const INVITE_MS = 4000;
const SHOWN_MS = 1500; // a prediction is shown for so long after the last event
const FRESH_MS = 200; // and its phase counts for so long
const NUMBERS_MS = 120;
const TRAIL_S = 2;
const STOPPED_MS = 250;

const canvas = part("live-scene");
const invitation = part("live-invitation");
const numbers = Object.fromEntries(["delay", "rate", "speed"].map((of) => [of, part("live-numbers").querySelector(`[data-of=${of}]`)]));

let demo = null;
let strip = null;
let active = false;
let drawing = false; // one loop, however often the view is opened
let trail = [];
let counted = []; // [ms, events] of the last second
let heard = -Infinity;
let judged = true;
let told = 0;
let frames = 0;
const movement = new Movement();
const tiles = new Tiles();
const ledger = part("live-ledger");
const first = new LiveCard(part("live-card-0"), (prediction, name) => {
  movement.predicted(0, prediction, name);
  tiles.predicted(prediction);
}, { choice: (choice) => tiles.chosen(choice) }, { encoding: "json" }); // packed predictions have no room for shares
const cards = [first, new LiveCard(part("live-card-1"), (prediction, name) => movement.predicted(1, prediction, name))];
let offeredTo = null; // the connection that knows where the tiles are

function moved(rows) {
  heard = performance.now();
  judged = false;
  counted.push([heard, rows.length]);
  trail.push(...rows.map(([t, x, y]) => [t, x, y]));
  movement.move(rows);
  tiles.move(rows);
  for (const card of cards) card.track?.connection.send(rows);
}

function frame(now) {
  drawing = active;
  if (!active) return;
  const seconds = performance.now() / 1000;
  trail = trail.slice(Math.max(0, trail.findIndex(([t]) => t > seconds - TRAIL_S)));
  if (trail.length && trail[trail.length - 1][0] < seconds - TRAIL_S) trail = [];
  offerTiles();
  const invites = now - heard > INVITE_MS;
  invitation.classList.toggle("away", !invites);
  if (invites) showDemo(now);
  else showPointer(now, seconds);
  const pace = speed(trail, seconds);
  const phase = cards[0].fresh(FRESH_MS)?.phase ?? null;
  frames += 1;
  if (!calm() || frames % 12 === 0) {
    strip.add(now, pace, phase);
    strip.draw(now);
  }
  if (now - told > NUMBERS_MS) tell(now, pace);
  requestAnimationFrame(frame);
}

function offerTiles() {
  const connection = first.track?.connection ?? null;
  if (!tiles.fit(canvas.clientWidth, canvas.clientHeight) && connection === offeredTo) return;
  offeredTo = connection;
  connection?.targets(tiles.list);
}

function pressed(row) {
  tiles.press(row);
  write(ledger, tiles.ledger.words || ledger.textContent);
}

function showDemo(now) {
  const shown = demo.at(now, calm());
  if (shown === null) drawNothing(canvas);
  else drawDemo(canvas, shown);
  canvas.dataset.shows = shown === null ? "nothing" : "demo";
}

function showPointer(now, seconds) {
  demo.restart();
  const drawn = drawLive(canvas, trail, cards.map((card) => card.fresh(SHOWN_MS)), seconds, tiles);
  canvas.dataset.shows = "pointer";
  canvas.dataset.ahead = tiles.proposed ?? "";
  canvas.dataset.drawn = Number(canvas.dataset.drawn ?? 0) + drawn;
  if (!judged && now - heard > STOPPED_MS) judge();
}

function tell(now, pace) {
  told = now;
  counted = counted.filter(([at]) => at > now - 1000);
  write(numbers.rate, number(counted.reduce((sum, [, events]) => sum + events, 0), 0, "/s"));
  write(numbers.speed, number(pace, 0, "px/s"));
  write(numbers.delay, number(cards[0].track?.delay(), 2, "ms"));
  for (const card of cards) card.tell(FRESH_MS);
}

function judge() {
  judged = true;
  const found = movement.verdict();
  movement.clear();
  if (found === null) return;
  const said = cards.flatMap(({ track }, i) =>
    track === null ? [] : [`${found.names[i] ?? track.predictor} ${found.errors[i] == null ? "said nothing" : `was ${number(found.errors[i])} px off`}`]);
  write(part("live-verdict"), `Half-way in time of those ${number(found.distance)} px, ${said.join(", ")}; your pointer was still ${number(found.hold)} px away.`);
}

/** Connects and draws from now on. */
export async function open() {
  active = true;
  strip ??= new Strip(part("live-strip"));
  strip.fit();
  if (!demo?.loaded) demo = new Demo(PREFERRED);
  for (const card of cards) card.open();
  if (!drawing) requestAnimationFrame(frame);
  drawing = true;
  await Promise.all([choices(), device.open()]);
}

/** Offers the predictors, and connects with those that are preferred. */
async function choices() {
  const listing = await predictors();
  if (cards[0].offered) return;
  offer(cards[0].select, listing.predictors, PREFERRED);
  offer(cards[1].select, listing.predictors, "", "none");
  for (const card of cards) card.offered = true;
  if (active) for (const card of cards) card.open();
}

/** Lets the connections go. */
export function close() {
  active = false;
  tiles.clear();
  device.close();
  for (const card of cards) card.close();
}

if (window.matchMedia("(pointer: coarse)").matches) write(invitation.querySelector("strong"), "Move your finger here");
follow(canvas, { moved, pressed: (row, event) => event.button === 0 && pressed(row) });
