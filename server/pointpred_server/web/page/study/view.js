// The page of a study: consent, questions, the task, and the end. A page that is opened again goes on where the last one was.

import { FrameLoop, onRepaint } from "../drawing/canvas.js";
import { part, sentence, write } from "../shell/elements.js";
import { listenToPointer } from "../shell/pointer.js";
import { aboutPage } from "./about-page.js";
import { drawTask } from "./picture.js";
import { Refused, read, Sender } from "./service.js";
import { ask, note } from "./sheet.js";
import { PointingTask } from "./task.js";

const MARGIN_PX = 4; // around the targets
const SETTLED_MS = 1000; // a window that was changed is noted then
const QUESTIONS = { before: "Before you begin", after: "A few questions" };
const AGAIN_MS = 2000;

const canvas = /** @type {HTMLCanvasElement} */ (part("task-scene"));
const progress = /** @type {HTMLProgressElement} */ (part("task-progress"));
const [statusLine, troubleBox] = ["task-status", "task-trouble"].map(part);
const loop = new FrameLoop(frame);
const sender = new Sender((message) => {
  trouble = message;
  note(message === null ? "" : `Not saved yet: ${message}. Please wait, and leave this page open.`);
  if (message !== null) task?.interrupt();
});

/** @type {PointingTask|null} */ let task = null;
let stored = 0; // movements, those on their way to the service among them
/** @type {string|null} */ let trouble = null; // why nothing is stored at the moment
let resized = 0; // the timer of a window that was changed
let pauses = true; // whether a sheet lies over the task
/** @type {(end: "rest"|"done") => void} */ let onPause = () => {};
/** @type {(error: unknown) => void} */ let onFailure = () => {};

const middle = () =>
  /** @type {[number, number]} */ ([canvas.clientWidth, canvas.clientHeight].map((px) => Math.round(px / 2)));

/** What the targets of a sequence take, px. @param {import("./task.js").Sequence} sequence */
function extent({ places, width, height }) {
  return [width, height ?? width].map(
    (size, axis) => 2 * Math.max(...places.map((place) => Math.abs(place[axis]))) + size + 2 * MARGIN_PX,
  );
}

/** Why nobody can point now; null where they can. @returns {string|null} */
function obstacle() {
  if (task === null) return null;
  if (trouble !== null)
    return `Your last movement is not saved yet: ${trouble}. Please wait, and leave this page open.`;
  if (pauses) return null;
  const sizes = [canvas.clientWidth, canvas.clientHeight],
    needed = extent(task.sequence);
  if (needed.every((size, axis) => size <= sizes[axis])) return null;
  const [wide, high] = needed.map(Math.ceil);
  return `This window is too small: the targets need ${wide} × ${high} px and have ${sizes.join(" × ")} px. Enlarge the window, or zoom out.`;
}

const isOpen = () => task !== null && !task.done && !pauses && obstacle() === null;

function frame() {
  if (task === null) return;
  const { sequence, total, before } = task;
  const why = obstacle();
  if (why !== null) task.interrupt();
  troubleBox.hidden = why === null;
  write(troubleBox, why ?? "");
  const phase = sequence.phase === "practice" ? "Practice. " : "";
  const how = task.running ? "" : " Click the filled target.";
  write(statusLine, `${phase}Movement ${Math.min(before + 1, total)} of ${total}.${how}`);
  [progress.max, progress.value] = [total, before];
  drawTask(canvas, {
    places: task.places,
    width: sequence.width,
    height: sequence.height,
    current: task.done || pauses || why !== null ? null : task.current,
    last: task.trials.at(-1) ?? null,
  });
  canvas.dataset.target = JSON.stringify(isOpen() ? { ...task.goal, running: task.running } : null);
}

/** @param {import("./task.js").Row} row */
function select(row) {
  if (task === null || !isOpen()) return;
  const trial = task.select(row);
  if (trial === null) return;
  save(trial);
  if (task.done) onPause("done");
  else if (task.sequence !== trial.sequence && task.sequence.rest) onPause("rest");
}

/** Sends a movement; the service decides what follows, since it ends repetitions. @param {import("./task.js").Trial} trial */
async function save({ start, rows, hit, clicks, lost }) {
  const { centre } = /** @type {PointingTask} */ (task);
  const at = performance.timeOrigin / 1000 + start[0];
  const message = { type: "trial", number: stored++, centre, start, rows, at, hit, clicks, lost };
  try {
    const state = await sender.send(message);
    const differs = String(state.next) !== String(task?.next ?? null);
    if (state.stored === stored && differs && !pauses) task?.resume(state.next);
  } catch (error) {
    onFailure(error);
  }
}

/** Shows the task until a break or its end; the picture goes on until all is stored. @returns {Promise<"rest"|"done">} */
function point() {
  part("sheet").hidden = true;
  part("task").hidden = false;
  place();
  pauses = false;
  loop.start();
  return new Promise((resolve, reject) => {
    onPause = resolve;
    onFailure = reject;
  }).finally(() => {
    pauses = true;
  });
}

/** The middle of the picture may have moved. */
function place() {
  const centre = middle();
  if (task === null || canvas.clientWidth === 0 || centre.join() === task.centre.join()) return;
  task.interrupt();
  task.centre = centre;
}

/** Waits until all is stored. @param {import("./service.js").State} state @returns {Promise<import("./service.js").State>} */
async function settled(state) {
  while (sender.waiting > 0) await new Promise((resolve) => setTimeout(resolve, 50));
  return { ...state, ...(await read()) };
}

/** @param {any} study */
async function questions(study, when) {
  if (!study.questions.includes(when)) return study;
  const asked = study.asked.filter((question) => question.when === when);
  const { answers } = await ask(QUESTIONS[when], "", { buttons: ["Continue"], questions: asked });
  return { ...study, ...(await sender.send({ type: "answers", when, answers })) };
}

async function run() {
  let study = await read();
  if (!study.agreed) {
    const { chosen } = await ask(study.title, study.consent, {
      buttons: ["I agree and take part", "I do not take part"],
    });
    if (chosen === "second") return ask("Thank you", "Nothing was stored. You can close this page.");
    study = { ...study, ...(await sender.send({ type: "consent", page: await aboutPage() })) };
  } else await sender.send({ type: "page", page: await aboutPage() });
  study = await questions(study, "before");
  if (study.next !== null) {
    const [sequence, movement] = study.next;
    const waitS = movement === 1 && study.plan[sequence - 1].rest ? study.break_s : 0; // a page opened again in a break
    await ask(study.title, study.instructions, { buttons: [study.stored ? "Continue" : "Start"], waitS });
    study = await work(study);
  }
  await questions(study, "after");
  return ask("The end", study.thanks);
}

/** The task, with its breaks. */
async function work(study) {
  task = new PointingTask(study.plan, middle(), study.on_error);
  stored = study.stored;
  task.resume(study.next);
  for (;;) {
    const end = await point();
    study = await settled(study);
    loop.stop();
    if (study.next === null) break;
    task.resume(study.next);
    if (end === "rest") await ask("A break", "Rest your hand.", { buttons: ["Continue"], waitS: study.break_s });
  }
  task = null;
  return study;
}

/** Notes the window again when it has another size. */
function noteWindow() {
  clearTimeout(resized);
  if (task === null) return;
  const note = async () => sender.send({ type: "page", page: await aboutPage() }).catch(onFailure);
  resized = setTimeout(note, SETTLED_MS);
}

async function begin() {
  try {
    await run();
  } catch (error) {
    if (!(error instanceof Refused)) {
      ask("One moment…", `The service does not answer: ${String(error)}. Trying again.`);
      setTimeout(begin, AGAIN_MS);
    } else if (error.status === 409) {
      await ask("This study goes on elsewhere", "It has been opened in another window or tab.", {
        buttons: ["Go on here"],
      });
      window.location.reload();
    } else ask("Something is wrong", sentence(error.message));
  }
}

onRepaint(place);
window.addEventListener("resize", noteWindow);
window.addEventListener("beforeunload", (event) => sender.waiting > 0 && event.preventDefault());
listenToPointer(canvas, {
  onMove: (rows) => task?.move(rows),
  onPress: (row, event) => event.pointerType !== "touch" && event.button === 0 && select(row),
  onRelease: (row, event) => event.pointerType === "touch" && select(row), // a finger has no path before it touches
});
begin();
