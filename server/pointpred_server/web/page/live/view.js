// The live view: the person's own pointer, and where each predictor says that its movement will end.

import { FrameLoop, prefersLessMotion } from "../drawing/canvas.js";
import { drawLegends } from "../drawing/legend.js";
import { SmoothRegions } from "../drawing/regions.js";
import { predictors } from "../service/listing.js";
import { cellsOf, part, write } from "../shell/elements.js";
import { explainPredictors } from "../shell/glossary.js";
import { median, number } from "../shell/numbers.js";
import { listenToPointer } from "../shell/pointer.js";
import { LiveCard } from "./card.js";
import { Demo, judge, positionAt } from "./demo.js";
import { describe, RecentLeads } from "./earliness.js";
import { Movement, speed } from "./movement.js";
import { drawLive, KEPT_S, recentPart } from "./picture.js";
import { markOf, publishDrawn, publishRegions } from "./prediction.js";
import { SpeedStrip } from "./strip.js";
import { opacitiesOf, Tiles } from "./tiles.js";

/**
 * @typedef {{marks: (import("./picture.js").Mark|null)[], speed: number, rate: number|null, delay: number|null}} Shown of each
 *   predictor; px/s, events a second, ms; null: as measured of the person's own
 */

const INVITE_MS = 4000;
const NUMBERS_MS = 120;
const STOPPED_MS = 250;
const SLOW_FRAMES = 12; // with less motion, the plot of speed is drawn once in so many frames
const DEMO_END_S = 0.02;

const canvas = /** @type {HTMLCanvasElement} */ (part("live-scene"));
const invitation = part("live-invitation");
const verdict = part("live-verdict");
const ledger = part("live-ledger");
const numbers = cellsOf(part("live-numbers"));

const loop = new FrameLoop(frame);
const demo = new Demo();
const demoRegions = new SmoothRegions();
const movement = new Movement();
const recentLeads = new RecentLeads();
const tiles = new Tiles();
const [firstParameters, secondParameters] = /** @type {HTMLDetailsElement[]} */ (
  [0, 1].map((which) => part(`live-parameters-${which}`))
);
const first = new LiveCard(
  part("live-card-0"),
  firstParameters,
  (prediction, name) => {
    movement.addPrediction(0, prediction, name);
    tiles.addPrediction(prediction);
  },
  { choice: (choice) => tiles.addChoice(choice) },
  { encoding: "json" },
); // packed predictions have no probabilities of targets
const second = new LiveCard(part("live-card-1"), secondParameters, (prediction, name) =>
  movement.addPrediction(1, prediction, name),
);
const cards = [first, second];

/** @type {SpeedStrip|null} */ let strip = null;
let active = false;
let trail = [];
let eventCounts = []; // [ms, events] of the last second
let movedAt = -Infinity;
let judged = true;
/** @type {{lead_s: number|null}|null} */ let clickedTile = null; // the tile that ended the movement, and how early it was proposed
let writeAt = 0;
let frames = 0;
/** @type {string|null} */ let ownVerdict = null; // the sentence on the person's own movement, while that of the demo is shown
/** @type {import("./takes.js").Take|null} */ let judgedTake = null; // the simulated movement that the sentence is on
/** @type {LiveCard["connection"]} */ let informed = null; // the connection that has the positions of the tiles
/** @type {typeof import("./recordings.js")|null} */ let recordings = null; // the module of what the tiles stand for, which follows when the first prediction is there

function move(rows) {
  movedAt = performance.now();
  if (judged) recordings?.clear();
  judged = false;
  eventCounts.push([movedAt, rows.length]);
  trail.push(...rows.map(([t, x, y]) => [t, x, y]));
  movement.move(rows);
  tiles.move(rows);
  for (const card of cards) card.connection?.send(rows);
}

function press(row) {
  movement.press(row[0]);
  clickedTile = tiles.press(row);
  write(ledger, tiles.account.text || ledger.textContent);
}

function frame(now) {
  const seconds = performance.now() / 1000;
  trail = recentPart(trail, seconds);
  if (trail.length && trail.at(-1)[0] < seconds - KEPT_S) trail = [];
  sendTiles();
  const inviting = now - movedAt > INVITE_MS;
  invitation.classList.toggle("away", !inviting);
  const shown = inviting ? showDemo(now) : showPointer(now);
  shown.marks.forEach((mark, i) => cards[i].fields.writeRegion(mark, canvas));
  publishRegions(canvas, shown.marks);
  frames += 1;
  if (!prefersLessMotion() || frames % SLOW_FRAMES === 0) {
    strip?.add(now, shown.speed, shown.marks[0]?.prediction.phase ?? null);
    strip?.draw(now);
  }
  if (now > writeAt) writeNumbers(now, shown);
}

function sendTiles() {
  const { connection } = first;
  const moved = tiles.layOut(canvas.clientWidth, canvas.clientHeight);
  if (connection?.state !== "open") tiles.clear();
  if (!moved && connection === informed) return;
  informed = connection;
  connection?.setTargets(tiles.list);
}

/** Shows the pointer's own movement. @param {number} now @returns {Shown} */
function showPointer(now) {
  demo.pause();
  if (ownVerdict !== null) write(verdict, ownVerdict);
  ownVerdict = judgedTake = null;
  const seconds = performance.now() / 1000,
    marks = cards.map((card) => card.mark(now));
  const { list, probabilities } = tiles;
  const proposed = marks[0] === null ? null : tiles.proposed; // no frame stays when the movement is over
  const endpoints = drawLive(canvas, trail, marks, seconds, {
    list,
    opacities: opacitiesOf(probabilities, marks[0]),
    proposed,
  });
  publish("pointer", proposed, endpoints);
  if (!judged && now - movedAt > STOPPED_MS) judgeMovement();
  return { marks, speed: speed(trail, seconds), rate: null, delay: null };
}

/** Shows a simulated movement; it counts in no average of the person's own. @param {number} now @returns {Shown} */
function showDemo(now) {
  const { clientWidth: width, clientHeight: height } = canvas,
    still = prefersLessMotion();
  if (first.select.value)
    demo.request(now, {
      predictor: first.select.value,
      parameters: first.parameters.values,
      tiles: tiles.list,
      width,
      height,
    });
  const moment = demo.at(now, still);
  if (moment === null) {
    drawLive(canvas, [], [], 0, { list: tiles.list, opacities: {}, proposed: null });
    publish("nothing", null, 0);
    return { marks: [null, null], speed: 0, rate: null, delay: null };
  }
  const { take, event, time } = moment,
    ended = time > take.rows[event][0] + DEMO_END_S && event === take.rows.length - 1;
  const answer = take.answers[event];
  const marks = [markOf(answer, demoRegions, now, ended ? 0 : 1, still), null],
    proposed = marks[0] === null ? null : take.proposals[event],
    tile = tiles.list.findIndex(({ id }) => id === take.tile);
  if (still) recordings?.showLoaded(tile);
  else recordings?.simulate(take, positionAt(moment, (performance.now() - now) / 1000), ended, tile);
  const opacities = opacitiesOf(Object.fromEntries((answer.targets ?? []).map(({ id, p }) => [id, p])), marks[0]);
  drawLive(canvas, take.rows.slice(0, event + 1), marks, time, { list: tiles.list, opacities, proposed }, "none");
  publish("demo", proposed, 0);
  if (ended || still) judgeDemo(take);
  const rate = take.rows.filter(([t]) => t <= time && t > time - 1).length;
  return { marks, speed: ended ? 0 : take.speeds[event], rate, delay: median(take.delays) };
}

/** Publishes what is drawn as data of the canvas. */
function publish(shows, proposed, endpoints) {
  canvas.dataset.shows = shows;
  canvas.dataset.ahead = proposed ?? "";
  publishDrawn(canvas, endpoints);
}

/** @param {number} now @param {Shown} shown */
function writeNumbers(now, { marks, speed: pace, rate, delay }) {
  writeAt = now + NUMBERS_MS;
  eventCounts = eventCounts.filter(([at]) => at > now - 1000);
  write(numbers.rate, number(rate ?? eventCounts.reduce((sum, [, events]) => sum + events, 0)));
  write(numbers.speed, number(pace));
  write(numbers.delay, number(delay ?? first.connection?.delay(), 2));
  marks.forEach((mark, i) => cards[i].fields.writeTimes(mark));
}

/** Writes how early the end of the person's movement was predicted. */
function judgeMovement() {
  judged = true;
  recordings?.settle();
  const result = movement.verdict(),
    tile = clickedTile;
  movement.clear();
  clickedTile = null;
  if (result === null) return;
  const chosen = cards.flatMap(({ connection }) => (connection === null ? [] : [connection.predictor]));
  const description = describe(result, chosen, tile, recentLeads);
  write(verdict, description.text);
  verdict.dataset.verdict = JSON.stringify({
    arrival: result.arrival,
    reached: result.reached,
    each: description.each,
    tile: description.tile,
  });
}

/** Writes how early the end of a simulated movement was predicted, once. @param {import("./takes.js").Take} take */
function judgeDemo(take) {
  if (take === judgedTake) return;
  judgedTake = take;
  const { verdict: result, tile } = judge(take, first.select.value, tiles.list);
  if (result === null) return;
  ownVerdict ??= verdict.textContent;
  write(verdict, `Simulated movement. ${describe(result, [first.select.value], tile, new RecentLeads(), "it").text}`);
}

/** Connects and draws from now on. */
export async function open() {
  active = true;
  strip ??= new SpeedStrip(part("live-strip"));
  strip.fit();
  drawLegends();
  for (const card of cards) card.open();
  loop.start();
  recordings?.open();
  await fillCards();
}

/** Offers the predictors, and connects with the recommended one. */
async function fillCards() {
  const listing = await predictors();
  if (first.isFilled) return;
  first.fill(listing.predictors, listing.recommended);
  second.fill(listing.predictors, "", "none");
  explainPredictors(part("live-glossary"), listing.predictors);
  if (active) for (const card of cards) card.open();
}

/** Takes the module of what the tiles stand for. @param {typeof import("./recordings.js")} module */
export function useRecordings(module) {
  recordings = module;
  if (active) module.open();
}

/** Closes the connections. */
export function close() {
  active = false;
  loop.stop();
  recordings?.close();
  tiles.clear();
  demo.close();
  for (const card of cards) card.close();
}

if (window.matchMedia("(pointer: coarse)").matches)
  write(/** @type {Element} */ (invitation.querySelector("strong")), "Move your finger here");
listenToPointer(
  part("live-picture"),
  { onMove: move, onPress: (row, event) => event.button === 0 && press(row) },
  canvas,
);
