// The live view: your own pointer, and where each predictor says that its movement will end.

import { calm } from "../drawing/canvas.js";
import { drawLive } from "./picture.js";
import { number, offer, part, write } from "../page/elements.js";
import { median } from "../circle/geometry.js";
import { explainPredictors } from "../page/glossary.js";
import { drawSwatches } from "../drawing/legend.js";
import * as device from "../device/view.js";
import { Demo, outcome } from "./demo.js";
import { Earliness, sentence } from "./earliness.js";
import { Movement, speed } from "./movement.js";
import { LiveCard, markOf } from "./card.js";
import { follow } from "../page/pointer.js";
import { CalmRegions } from "../drawing/regions.js";
import { predictors } from "../service/http.js";
import { Strip } from "./strip.js";
import { Tiles, tints } from "./tiles.js";

const INVITE_MS = 4000;
const NUMBERS_MS = 120;
const TRAIL_S = 2;
const STOPPED_MS = 250;

const canvas = part("live-scene");
const invitation = part("live-invitation");
const verdict = part("live-verdict");
const numbers = Object.fromEntries(["delay", "rate", "speed"].map((of) => [of, part("live-numbers").querySelector(`[data-of=${of}]`)]));

let strip = null;
let active = false;
let drawing = false; // one loop, however often the view is opened
let trail = [];
let counted = []; // [ms, events] of the last second
let heard = -Infinity;
let judged = true;
let clicked = null; // what is known of the tile that ended the movement
let tellAt = 0;
let frames = 0;
let own = null; // the sentence on your own movement, while the demo's stands in its place
const demo = new Demo();
const demoRegions = new CalmRegions();
const movement = new Movement();
const earliness = new Earliness();
const tiles = new Tiles();
const ledger = part("live-ledger");
const first = new LiveCard(part("live-card-0"), part("live-parameters-0"), (prediction, name) => {
  movement.predicted(0, prediction, name);
  tiles.predicted(prediction);
}, { choice: (choice) => tiles.chosen(choice) }, { encoding: "json" }); // packed predictions have no room for shares
const second = new LiveCard(part("live-card-1"), part("live-parameters-1"), (prediction, name) => movement.predicted(1, prediction, name));
const cards = [first, second];
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

function pressed(row) {
  movement.press(row[0]);
  clicked = tiles.press(row);
  write(ledger, tiles.ledger.words || ledger.textContent);
}

function frame(now) {
  drawing = active;
  if (!active) return;
  trail = trail.slice(Math.max(0, trail.findIndex(([t]) => t > performance.now() / 1000 - TRAIL_S)));
  if (trail.length && trail[trail.length - 1][0] < performance.now() / 1000 - TRAIL_S) trail = [];
  offerTiles();
  const invites = now - heard > INVITE_MS;
  invitation.classList.toggle("away", !invites);
  const shown = invites ? showDemo(now) : showPointer(now);
  shown.marks.forEach((mark, i) => cards[i].tellRegion(mark, canvas));
  canvas.dataset.regions = JSON.stringify(shown.marks.map((mark) => mark && { ...mark.regions, opacity: mark.opacity }));
  frames += 1;
  if (!calm() || frames % 12 === 0) {
    strip.add(now, shown.speed, shown.marks[0]?.prediction.phase ?? null);
    strip.draw(now);
  }
  if (now > tellAt) tell(now, shown);
  requestAnimationFrame(frame);
}

function offerTiles() {
  const connection = first.track?.connection ?? null;
  const fitted = tiles.fit(canvas.clientWidth, canvas.clientHeight);
  if (connection?.state !== "open") tiles.clear();
  if (!fitted && connection === offeredTo) return;
  offeredTo = connection;
  connection?.targets(tiles.list);
}

/** The pointer's own movement. */
function showPointer(now) {
  demo.pause();
  if (own !== null) write(verdict, own);
  own = null;
  const seconds = performance.now() / 1000, marks = cards.map((card) => card.mark(now));
  const { list, shares, proposed } = tiles;
  const drawn = drawLive(canvas, trail, marks, seconds, { list, shares: tints(shares, marks[0]), proposed });
  show("pointer", proposed, drawn);
  if (!judged && now - heard > STOPPED_MS) judge();
  return { marks, speed: speed(trail, seconds), rate: null, delay: null };
}

/** A simulated movement, which moves as yours would: nothing of it goes into what is counted of yours. */
function showDemo(now) {
  const { clientWidth: width, clientHeight: height } = canvas;
  if (first.select.value) demo.ask(now, { predictor: first.select.value, parameters: first.parameters.values, tiles: tiles.list, width, height });
  const moment = demo.at(now, calm());
  const none = { list: tiles.list, shares: {}, proposed: null };
  if (moment === null) {
    drawLive(canvas, [], [], 0, none);
    show("nothing", null, 0);
    return { marks: [null, null], speed: 0 };
  }
  const { take, event, passed } = moment, over = passed > take.rows[event][0] + 0.02 && event === take.rows.length - 1;
  const answer = take.answers[event];
  const marks = [markOf(answer, demoRegions, now, over ? 0 : 1, calm()), null];
  const shares = tints(Object.fromEntries((answer.targets ?? []).map(({ id, p }) => [id, p])), marks[0]);
  drawLive(canvas, take.rows.slice(0, event + 1), marks, passed, { list: tiles.list, shares, proposed: take.proposals[event] }, "none");
  show("demo", take.proposals[event], 0);
  if (over || calm()) sayDemo(take);
  const rate = take.rows.filter(([t]) => t <= passed && t > passed - 1).length;
  return { marks, speed: over ? 0 : take.speeds[event], rate, delay: median(take.delays) };
}

function show(what, ahead, drawn) {
  canvas.dataset.shows = what;
  canvas.dataset.ahead = ahead ?? "";
  canvas.dataset.drawn = Number(canvas.dataset.drawn ?? 0) + drawn;
}

function tell(now, { marks, speed: pace, rate, delay }) {
  tellAt = now + NUMBERS_MS;
  counted = counted.filter(([at]) => at > now - 1000);
  write(numbers.rate, number(rate ?? counted.reduce((sum, [, events]) => sum + events, 0)));
  write(numbers.speed, number(pace));
  write(numbers.delay, number(delay ?? cards[0].track?.delay(), 2));
  marks.forEach((mark, i) => cards[i].tell(mark));
}

/** Says how early the end of your movement was known. */
function judge() {
  judged = true;
  const found = movement.verdict(), tile = clicked;
  movement.clear();
  clicked = null;
  if (found === null) return;
  const chosen = cards.flatMap(({ track }) => (track === null ? [] : [track.predictor]));
  const said = sentence(found, chosen, tile, earliness);
  write(verdict, said.words);
  verdict.dataset.verdict = JSON.stringify({ arrival: found.arrival, reached: found.reached, each: said.each, tile: said.tile });
}

function sayDemo(take) {
  const { verdict: found, tile } = outcome(take, first.select.value, tiles.list);
  if (found === null) return;
  own ??= verdict.textContent;
  write(verdict, `Simulated movement. ${sentence(found, [first.select.value], tile, new Earliness(), "it").words}`);
}

/** Connects and draws from now on. */
export async function open() {
  active = true;
  strip ??= new Strip(part("live-strip"));
  strip.fit();
  drawSwatches();
  for (const card of cards) card.open();
  if (!drawing) requestAnimationFrame(frame);
  drawing = true;
  await Promise.all([choices(), device.open()]);
}

/** Offers the predictors, and connects with the one that is recommended. */
async function choices() {
  const listing = await predictors();
  if (first.offered) return;
  offer(first.select, listing.predictors, listing.recommended);
  offer(second.select, listing.predictors, "", "none");
  for (const card of cards) card.offer(listing.predictors);
  explainPredictors(part("live-words"), listing.predictors);
  if (active) for (const card of cards) card.open();
}

/** Lets the connections go. */
export function close() {
  active = false;
  tiles.clear();
  demo.close();
  device.close();
  for (const card of cards) card.close();
}

if (window.matchMedia("(pointer: coarse)").matches) write(invitation.querySelector("strong"), "Move your finger here");
follow(canvas, { moved, pressed: (row, event) => event.button === 0 && pressed(row) });
