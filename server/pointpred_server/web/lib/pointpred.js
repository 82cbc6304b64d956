/**
 * The browser client of pointpred: streams pointer events to a service, and receives predictions of where the movement will end.
 *
 *     import { connect } from "/pointpred.js";
 *     const connection = connect();
 *     connection.on("prediction", ({ x, y }) => x !== null && mark(x, y));
 *
 * Positions are CSS px of the viewport (clientX, clientY; y down), those of getBoundingClientRect. With
 * `coordinates: "screen"` they are CSS px of the screen, and predictions stay valid when the window moves.
 * Browsers report no device counts, so none are sent. Nothing is loaded from other hosts.
 *
 * Types, options and messages: `index.d.ts`.
 *
 * @import * as types from "./index.d.ts"
 * @import { Choice, ConnectOptions, EventRow, Goal, Messages, Mixture, NamedTarget, PointerSample, State, Welcome } from "./index.d.ts"
 */

import { findRefusal, isOwn, socketAddress, warningFor } from "./client/address.js";
import { needDocument } from "./client/document.js";
import { EventQueue } from "./client/event-queue.js";
import { decode, row, targetsFrame } from "./client/frames.js";
import { PageChoices } from "./client/page-choices.js";
import { PageSocket } from "./client/page-socket.js";
import { Person } from "./client/person.js";
import { PointerStream } from "./client/pointer-stream.js";
import { Proposals } from "./client/proposals.js";
import { ServiceChoices } from "./client/service-choices.js";
import { Settings } from "./client/settings.js";
import { RetryingSocket } from "./client/socket.js";
import { Targets } from "./client/targets.js";
import { VERSION } from "./laws/fields.js";
import { RECOMMENDED } from "./laws/registry.js";

export { regionOf } from "./client/regions.js";

const NO_TARGETS = targetsFrame([]).text;
const MOST_BUFFERED = 2 ** 20; // bytes the browser may hold back before events are dropped: half a minute of a fast mouse
const REST_MS = 100; // a pointer without events for this long is at rest
const MOST_UNANSWERED = 4096;
const NAMES = ["prediction", "cursor", "choice", "error", "state", "welcome", "score", "person", "targets", "bye"];

/**
 * Opens a connection and keeps it open.
 * @param {string|URL} [url] of the service or its stream, http or ws; the service that this module came from by default
 * @param {ConnectOptions} [options]
 * @returns {Connection}
 */
export function connect(url, options = {}) {
  needDocument("connect");
  return new Connection(url, options);
}

/** One pointing session; if the connection is lost, another session is opened. @implements {types.Connection} */
export class Connection {
  /** @type {State} */ state = "connecting";
  /** The newest `welcome`. @type {Welcome|null} */ welcome = null;
  /** The newest time from sending events to receiving their prediction, ms. @type {number|null} */ delayMs = null;
  /** Events sent to the service. */ sent = 0;
  #url;
  #options;
  #settings;
  #socket;
  #listeners = new Map(NAMES.map((name) => [name, new Set()]));
  #queue;
  #unanswered = [];
  #sentAt = 0;
  #errorCode = "";
  #warned = false;
  #ids = [];
  #sentIds = []; // of the targets that the service has, and of those sent that it has not answered
  #sentTargets = NO_TARGETS;
  #targetCount = 0;
  #omitted = 0;
  #probabilities = [];
  /** @type {PointerStream|null} */ #pointer = null;
  #targets;
  #person;
  /** @type {{type: "enter", key: string, x: number, y: number}|null} */ #window = null;
  #newestTime = -Infinity;
  #eventAt = -Infinity;
  #paused = false;
  #scrolled = false; // s, ms; whether choices wait for an event
  #pageChoices;
  #serviceChoices;
  /** @type {Proposals<Choice>} */ #proposals = new Proposals((choice) =>
    this.#emit("choice", this.#withElement(choice)),
  );
  #stop = new AbortController();
  #timer;

  /** Use `connect`. @param {string|URL|undefined} url @param {ConnectOptions} options */
  constructor(url, options) {
    const given = withoutUndefined(options);
    this.#options = {
      predictor: RECOMMENDED,
      reply: "frame",
      encoding: given.page ? "json" : "binary",
      element: window,
      pointer: true,
      coordinates: "client",
      targets: [],
      queue: 8192,
      ...given,
    };
    this.#url = url;
    this.#queue = new EventQueue(this.#options.queue);
    const { predictor, parameters = {}, device, reply, encoding, assist, places } = this.#options;
    const screen = {
      width_px: window.screen?.width || undefined,
      height_px: window.screen?.height || undefined,
      ...this.#options.screen,
    };
    this.#settings = new Settings({
      type: "hello",
      version: VERSION,
      predictor,
      parameters,
      device,
      screen,
      reply,
      encoding,
      assist,
      places,
    });
    this.#person = new Person(this.#options.person ?? "", predictor, {
      send: (message) => this.#transmit(JSON.stringify(message)),
      onChange: (person) => this.#emit("person", { type: "person", person }),
    });
    const handlers = {
      onOpen: () => this.#socket.send(this.#settings.hello(this.#person.hello(this.#settings.predictor))),
      onMessage: (data) => this.#receive(data),
      onClose: () => this.#endSession(),
    };
    this.#socket = given.page ? new PageSocket(handlers) : new RetryingSocket(() => this.#address, handlers);
    const { element, pointer, coordinates, targets } = this.#options;
    const onScreen = coordinates === "screen",
      { signal } = this.#stop;
    if (pointer)
      this.#pointer = new PointerStream(element, { onScreen, onRows: (rows) => this.#addRows(rows), signal });
    const offset = () => (onScreen && this.#pointer?.offset) || [0, 0];
    this.#targets = new Targets(targets, { offset, onChange: (scrolled) => this.#updateTargets(scrolled), signal });
    this.#pageChoices = new PageChoices(element, {
      pointer,
      idOf: (one) => this.#targets.id(one),
      onLeave: () => this.#pause(),
      proposals: this.#proposals,
      signal,
    });
    this.#serviceChoices = new ServiceChoices(this.#proposals, this.#pageChoices);
    window.addEventListener("online", () => this.state === "waiting" && this.#open(), { signal });
    this.#timer = setInterval(() => this.#keepAlive(), 1000);
    this.#open();
  }

  /** The id of the target that was proposed last and still is. @returns {string|null} */
  get proposed() {
    return this.#proposals.newest;
  }

  /**
   * The law of the endpoint by targets, places and elsewhere, as the newest prediction has it, where the page predicts; null where
   * the service does.
   * @returns {Mixture|null}
   */
  get mixture() {
    return this.#socket instanceof PageSocket ? this.#socket.mixture : null;
  }

  /** Events dropped because there was no connection for too long, or a slow one. @returns {number} */
  get dropped() {
    return this.#queue.dropped;
  }

  /**
   * Calls `listener` with every message of that name from now on.
   * @template {keyof Messages} Name
   * @param {Name} name @param {(message: Messages[Name]) => void} listener
   * @returns {() => void} removes the listener
   */
  on(name, listener) {
    const listeners = this.#listeners.get(name);
    if (!listeners) throw new TypeError(`unknown event ${name}; known: ${NAMES.join(", ")}`);
    listeners.add(listener);
    return () => listeners.delete(listener);
  }

  /**
   * Sends events: in one message, or in several where the limits of the service require it.
   * @param {readonly (EventRow|PointerSample)[]} events in the order of time; equal times are normal
   */
  send(events) {
    this.#pointer?.flush();
    if (events.length) this.#addRows(events.map(row));
  }

  /** Replaces the targets that are rectangles; those of `observe` stay. @param {readonly NamedTarget[]} list */
  targets(list) {
    this.#targets.replace(list);
  }

  /**
   * Makes an element a target and follows it: within a frame while the pointer moves or something scrolls or changes its
   * size, otherwise within a quarter of a second. It is a target while a part of it is in view.
   * @param {Element} element @param {string} [id] the element's own id by default
   * @returns {string} the id
   */
  observe(element, id) {
    const observedId = this.#targets.observe(element, id);
    this.#pageChoices.update();
    return observedId;
  }

  /** Stops following an element. @param {Element} element */
  unobserve(element) {
    this.#targets.unobserve(element);
    this.#pageChoices.update();
  }

  /**
   * How likely the pointer is heading for a target: its probability in the newest prediction, 0 beyond the likeliest five.
   * With `encoding: "binary"` probabilities come with choices only: that of the newest proposal, while it stands.
   * @param {Element|string} target an observed element, or an id @returns {number} 0 to 1
   */
  probability(target) {
    const newest = this.#settings.encoding === "binary" ? this.#serviceChoices.current : this.#probabilities;
    return newest.find(({ id, element }) => id === target || (element && element === target))?.p ?? 0;
  }

  /**
   * Marks the start or the end of a movement; the end is answered by `score`.
   * @param {"start"|"end"} action @param {Goal|Element|null} [target] the true target, if it is known
   * @param {Object<string, string|number>} [conditions] what the trial is (block, participant), which a service that records keeps;
   *   those of the end add to those of the start, and all trials have the names of the first
   */
  trial(action, target, conditions) {
    const goal = target instanceof Element ? this.#targets.goal(target) : target;
    this.#sendMessage({ type: "trial", action, ...(goal && { target: goal }), ...(conditions && { conditions }) });
  }

  /**
   * Changes options; another predictor or other parameters start without memory. Answered by `welcome`.
   * Another token is used when the connection is next opened.
   * @param {Parameters<types.Connection["configure"]>[0]} changes
   */
  configure({ token = this.#options.token, ...changes }) {
    this.#pointer?.flush();
    this.#options.token = token;
    const helloSent = this.state === "connecting" && this.#socket.isOpen;
    if (this.state === "open" && Object.keys(changes).length) this.#request(changes);
    else if (helloSent) this.#settings.request(changes);
    else this.#settings.apply(changes);
    if (this.state === "refused") this.#open();
  }

  /**
   * Requests what finished movements have taught about the person: a short string for `person` of another connection, ""
   * for nothing. Without a session, the newest string of the client. With `person` the session starts anew with that string;
   * "" forgets the person. The current movement is not included: `reset()` finishes it.
   * @param {string} [person] @returns {Promise<string>} rejects if the service refuses `person`
   */
  async person(person) {
    this.#pointer?.flush();
    if (this.#canSend) {
      if (person !== undefined) this.#unanswered = [];
      return this.#person.request(person);
    }
    if (person !== undefined) this.#person.store(person, this.#settings.predictor);
    return this.#person.description;
  }

  /**
   * The next movement is in this window or page: places are remembered for each name, relative to the origin, so that
   * they move with it. A movement that goes on stays in the window it began in; `reset` ends it.
   * @param {string} key "" is what it is without a name @param {number} [x] of the origin, px @param {number} [y]
   */
  enter(key, x = 0, y = 0) {
    const message = { type: /** @type {const} */ ("enter"), key, x, y };
    this.#unanswered = [];
    if (this.#canSend) this.#window = message;
    this.#sendMessage(message);
  }

  /** Forgets the person, in the session and in this client, and events that wait for a connection. @returns {Promise<string>} "", when that is done */
  async forget() {
    this.#pointer?.flush();
    this.#unanswered = [];
    if (this.#canSend) return this.#person.forget();
    this.#queue.dropEvents();
    this.#person.store("", this.#settings.predictor);
    return "";
  }

  /** Forgets every event: the next one starts a movement. */
  reset() {
    this.#unanswered = [];
    this.#sendMessage({ type: "reset" });
  }

  /** Ends the session for good and stops listening to the page. */
  close() {
    if (this.state === "closed") return;
    this.#pointer?.flush();
    this.#stop.abort();
    clearInterval(this.#timer);
    this.#socket.close(JSON.stringify({ type: "bye" }));
    this.#person.endSession();
    this.#proposals.clear();
    this.#setState("closed");
  }

  get #address() {
    return socketAddress(this.#url, this.#options.token);
  }

  #open() {
    this.#socket.cancelRetry();
    this.#errorCode = "";
    this.#setState("connecting");
    if (this.state === "connecting") this.#socket.open(); // a listener may have closed the connection
  }

  /** Whether what is sent now goes out. */
  get #canSend() {
    return this.state === "open" && this.#socket.isOpen;
  }

  #endSession() {
    this.#unanswered = [];
    this.#settings.applyPending();
    this.#person.endSession();
    this.#paused = false;
    this.#serviceChoices.endSession();
    this.#probabilities = [];
    if (this.#errorCode === "unauthorized" || this.#errorCode === "hello") return this.#setState("refused");
    if (this.#errorCode === "idle" && this.#queue.length === 0) return this.#setState("idle");
    this.#socket.retry(() => this.#open());
    this.#setState("waiting");
    if (!this.#socket.opened && !this.#options.page) this.#findRefusal(this.#address);
  }

  /** If the origin of the page is not allowed, stops trying and reports which flag allows it. */
  async #findRefusal(address) {
    if (this.welcome && isOwn(address)) return;
    const message = await findRefusal(address);
    const trying = this.state === "waiting" || (this.state === "connecting" && !this.#socket.opened);
    if (this.#errorCode === "unauthorized" || !trying) return;
    const reported = message !== null && /** @type {Set<Function>} */ (this.#listeners.get("error")).size > 0; // then the page shows it where it likes
    if (!reported && (this.welcome === null || message !== null)) this.#warn(warningFor(address, message));
    if (message === null) return;
    this.#errorCode = "unauthorized";
    this.#socket.cancelRetry();
    this.#emit("error", { type: "error", code: "unauthorized", message, path: null, recoverable: false });
    if (this.state === "waiting") this.#setState("refused"); // an attempt under way ends there by itself
  }

  /** Warns once per connection, however often it tries. */
  #warn(message) {
    if (!this.#warned) console.warn(message);
    this.#warned = true;
  }

  #receive(data) {
    if (data instanceof ArrayBuffer) {
      for (const prediction of decode(data, this.#ids)) this.#addPrediction(prediction);
      return;
    }
    const message = typeof data === "string" ? JSON.parse(data) : data;
    if (message.type === "prediction")
      return this.#addPrediction({ region: null, phase: null, remaining_s: null, ...message });
    if (message.type === "choice") return this.#serviceChoices.receive(this.#withElement(message));
    if (message.type === "person")
      return this.#person.receive(message.person, /** @type {Welcome} */ (this.welcome).predictor);
    if (message.type === "targets") this.#ids = this.#sentIds.shift() ?? [];
    if (message.type === "welcome") this.#beginSession(message);
    if (message.type === "error") this.#handleError(message);
    if (this.#listeners.has(message.type)) this.#emit(message.type, message);
  }

  /** Adds the observed element that has the id. */
  #withElement(one) {
    const element = this.#targets.element(one.id);
    return element === undefined ? one : { ...one, element };
  }

  #addPrediction(prediction) {
    this.#serviceChoices.confirm(prediction.t);
    if (prediction.targets)
      prediction.targets = this.#probabilities = prediction.targets.map((one) => this.#withElement(one));
    const unanswered = this.#unanswered;
    while (unanswered.length && unanswered[0].t < prediction.t) unanswered.shift();
    if (unanswered.length && unanswered[0].t === prediction.t) this.delayMs = performance.now() - unanswered.shift().at;
    this.#emit("prediction", prediction);
  }

  /** The service has answered hello or configure. */
  #beginSession(welcome) {
    this.welcome = welcome;
    if (this.state === "open") return this.#settings.confirm();
    this.#socket.beginSession();
    for (const changes of this.#settings.takePending()) this.#request(changes);
    this.#person.beginSession();
    if (this.#window !== null) this.#transmit(JSON.stringify(this.#window));
    [this.#sentTargets, this.#sentIds, this.#ids] = [NO_TARGETS, [], []];
    this.#sendTargets();
    if (this.state === "closed") return; // by a listener of an error
    for (const { rows, message } of this.#queue.drain(welcome.limits, this.#targetCount, this.#settings.places)) {
      if (rows) {
        this.#serviceChoices.setPast(rows.at(-1)[0]);
        this.#sendRows(rows);
      } else {
        if (message.type === "enter") this.#window = message;
        this.#transmit(JSON.stringify(message));
      }
    }
    this.#pageChoices.detectsEntry = false;
    this.#setState("open");
  }

  #handleError({ code, path, message }) {
    this.#errorCode = code;
    if (path?.startsWith("$.targets")) this.#sentIds.shift();
    if (path === "$.person") return this.#rejectPerson(message);
    if (this.state === "connecting" && (code === "unknown_predictor" || code === "bad_field")) {
      this.#errorCode = "hello";
      this.#abandonSocket();
    } else if (
      code === "unknown_predictor" ||
      /^\$\.(predictor|parameters|reply|precision|assist|places)/.test(path ?? "")
    ) {
      this.#settings.reject();
    }
  }

  /** The service refuses the person: an open session keeps its own, a new one is opened without. */
  #rejectPerson(message) {
    if (this.state !== "connecting") return this.#person.reject(message);
    this.#person.store("");
    this.#abandonSocket();
  }

  #abandonSocket() {
    this.#socket.close();
    this.#endSession();
  }

  /** Requests a change of the open session. */
  #request(changes) {
    this.#settings.request(changes);
    this.#transmit(JSON.stringify({ type: "configure", ...changes }));
  }

  #addRows(rows) {
    this.#targets.activate();
    if (this.#paused) this.#pageChoices.detectsEntry = this.state !== "open";
    [this.#paused, this.#scrolled, this.#eventAt] = [false, false, performance.now()];
    if (this.#canSend) this.#sendRows(rows);
    else this.#enqueue(rows);
  }

  #sendRows(rows) {
    const { limits } = /** @type {Welcome} */ (this.welcome);
    this.#newestTime = rows.at(-1)[0];
    for (const { frame, last, count } of this.#socket.frames(rows, this.#settings.encoding, limits)) {
      if (this.#socket.bufferedAmount > MOST_BUFFERED) {
        this.#queue.dropped += count;
        continue;
      }
      this.#transmit(frame);
      this.sent += count;
      this.#unanswered.push({ t: last, at: performance.now() });
      if (this.#unanswered.length > MOST_UNANSWERED) this.#unanswered.shift();
    }
  }

  #sendMessage(message) {
    this.#pointer?.flush();
    if (this.#canSend) this.#transmit(JSON.stringify(message));
    else this.#enqueue([message]);
  }

  #transmit(frame) {
    this.#sentAt = performance.now();
    this.#socket.send(frame);
  }

  #enqueue(items) {
    if (this.state === "closed") throw new Error("the connection is closed");
    this.#queue.add(items);
    if (this.state === "idle") this.#open();
  }

  /** Keeps the session of a visible page open; a hidden page lets it end, and the next event opens another. */
  #keepAlive() {
    if (this.#canSend) this.#person.refresh(this.sent);
    if (this.state !== "open" || document.hidden) return;
    if (performance.now() - this.#sentAt < (1000 * /** @type {Welcome} */ (this.welcome).limits.idle_s) / 3) return;
    this.#sendTargets(true);
  }

  /** The pointer has left, or the page has moved under it: choices of the service wait for the next event. */
  #pause() {
    this.#pointer?.flush();
    if (!this.#canSend || this.#paused) return;
    this.#paused = true;
    this.#serviceChoices.pause(this.#newestTime);
  }

  /** Elements may have moved; after a scroll or a resize, a pointer at rest sends no event that shows it. */
  #updateTargets(scrolled) {
    if (this.#sendTargets() && scrolled) this.#scrolled = true;
    if (this.#scrolled && performance.now() - this.#eventAt > REST_MS) this.#pause();
  }

  /** Sends the targets if they have changed, or `always`. @returns {boolean} whether they were sent */
  #sendTargets(always = false) {
    if (!this.#socket.hasSession) return false;
    const list = this.#targets.list(),
      { text, omitted, count } = targetsFrame(list, /** @type {Welcome} */ (this.welcome).limits);
    if (text === this.#sentTargets && !always) return false;
    [this.#sentTargets, this.#targetCount] = [text, count];
    if (count === 0) this.#probabilities = [];
    this.#sentIds.push(list.slice(0, count).map(({ id }) => id));
    this.#transmit(text);
    const before = this.#omitted;
    this.#omitted = omitted;
    const message = `${omitted} targets beyond the first ${count} were left out: the service takes no more`;
    if (omitted > before)
      this.#emit("error", { type: "error", code: "too_many", message, path: "$.targets", recoverable: true });
    return true;
  }

  #setState(state) {
    if (state === this.state) return;
    this.state = state;
    this.#emit("state", state);
  }

  #emit(name, message) {
    for (const listener of /** @type {Set<Function>} */ (this.#listeners.get(name))) {
      try {
        listener(message);
      } catch (error) {
        reportError(error); // is logged, and does not keep other listeners from being called
      }
    }
  }
}

/** An option that is undefined counts as not given. */
const withoutUndefined = (options) =>
  Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined));
