/**
 * The browser client of pointpred: streams pointer events to a service, receives where the movement will end.
 *
 *     import { connect } from "/pointpred.js";
 *     const connection = connect();
 *     connection.on("prediction", ({ x, y }) => x !== null && mark(x, y));
 *
 * Positions are CSS px of the viewport (clientX, clientY; y down), those of getBoundingClientRect. With
 * `coordinates: "screen"` they are CSS px of the screen: what is predicted then survives moves of the window.
 * Browsers give no device counts, so none are sent. Nothing is loaded from elsewhere.
 *
 * @typedef {[number, number, number, number|null, number|null, number]} EventRow t s, x px, y px, counts, buttons
 * @typedef {{t: number, x: number, y: number, dx?: number|null, dy?: number|null, buttons?: number}} EventRecord
 * @typedef {{id: string, x: number, y: number, width: number, height: number, weight?: number}} Target upper left corner,
 *   size, px; how likely it is beforehand, relative to the others
 * @typedef {{x: number, y: number, width: number}} Goal centre and width, px
 * @typedef {"connecting"|"open"|"waiting"|"idle"|"refused"|"closed"} State `waiting`: will try again; `idle`: the
 *   service let a silent session go, the next event opens another; `refused`: waits for configure(); `closed`: for good
 * @typedef {{type: "prediction", t: number, x: number|null, y: number|null,
 *   region: {sxx: number, sxy: number, syy: number, tail: number|null}|null, phase: "still"|"ballistic"|"corrective"|null,
 *   remaining_s: number|null, targets?: {id: string, p: number, element?: Element}[]}} Prediction null: nothing is
 *   justified now; targets: the likeliest five, with encoding "json"; element: the observed one
 * @typedef {{x: number, y: number, major: number, minor: number, angle: number}} Ellipse centre and half axes, px; radians
 * @typedef {{type: "cursor", t: number, x: number, y: number, added_px: number}} Cursor where the service has moved the
 *   cursor, px, and how much of that was help since the session began
 * @typedef {{type: "choice", id: string, p: number, action: "propose"|"retract", t: number|null,
 *   reason: "predicted"|"entered"|"focus"|"touch"|null, element?: Element}} Choice reason: why it is proposed: the movement heads for it, the
 *   pointer has gone into it, the keyboard's focus or a finger has come to it; null where it is retracted
 * @typedef {{type: "error", code: string, message: string, path: string|null, recoverable: boolean}} Fault
 * @typedef {{type: "welcome", version: number, session: string, predictor: string, limits: Limits}} Welcome
 * @typedef {{max_frame_bytes: number, max_events_per_frame: number, max_events_per_s: number, max_targets: number,
 *   max_sessions: number, idle_s: number}} Limits
 * @typedef {{type: "score", events: number, time_averaged_px: number|null, hold_px: number|null, skill: number|null,
 *   by_time: Object<string, number>, by_path: Object<string, number>, reason: string|null,
 *   fired: number|null, hit: boolean|null, wasted: number|null, lead_s: number|null}} Score
 * @typedef {{prediction: Prediction, cursor: Cursor, choice: Choice, error: Fault, state: State, welcome: Welcome, score: Score,
 *   person: PersonKnown, targets: {type: "targets", count: number}, bye: {type: "bye", reason: string}}} Messages by the name to listen for
 * @typedef {{type: "person", person: string}} PersonKnown what finished movements taught of the person, "" for nobody
 * @typedef {Object} Options
 * @property {string} [predictor] a name of the registry; "kinematic-adaptive" unless given
 * @property {Object<string, number|string|boolean>} [parameters] of the predictor or its differentiator
 * @property {{cpi?: number, rate_hz?: number}} [device]
 * @property {{width_px?: number, height_px?: number, dpi?: number}} [screen] 96 px per inch and this screen unless given
 * @property {"frame"|"event"} [reply] one prediction a message, or one an event
 * @property {"binary"|"json"} [encoding] of events and predictions
 * @property {{strength?: number, rho?: number, function?: "constant"|"sigmoid", gain?: number}} [assist] the service moves
 *   the cursor by the counts of events, helped towards the predicted endpoint; needs `device.cpi` and counts
 * @property {string} [person] what a session knew of the person; nobody unless given
 * @property {string} [token] where the service asks for one
 * @property {EventTarget} [element] whose pointer events are streamed; the window unless given
 * @property {boolean} [pointer] false: only what `send` is given
 * @property {"client"|"screen"} [coordinates]
 * @property {Target[]} [targets]
 * @property {number} [queue] events kept while there is no connection; the oldest give way
 */

import { address, own, refusal, unconnected } from "/web/client/address.js";
import { decode, frames, row, targetsFrame } from "/web/client/frames.js";
import { ServiceChoices } from "/web/client/choices.js";
import { Entry } from "/web/client/entry.js";
import { Person } from "/web/client/person.js";
import { PointerStream } from "/web/client/pointer.js";
import { Proposals } from "/web/client/proposals.js";
import { Queue } from "/web/client/queue.js";
import { TargetWatch } from "/web/client/targets.js";
import { Wishes } from "/web/client/wishes.js";

export { regionOf } from "/web/client/regions.js";

const SUBPROTOCOL = "pointpred.v1";
const NO_TARGETS = targetsFrame([]).text;
const MOST_BUFFERED = 2 ** 20; // bytes the browser may hold back before events give way: a fast mouse for half a minute
const FIRST_WAIT_MS = 250;
const LONGEST_WAIT_MS = 8000;
const REST_MS = 100; // a pointer without events for so long rests
const STEADY_MS = 2000; // a connection that held so long starts the waits anew
const NAMES = ["prediction", "cursor", "choice", "error", "state", "welcome", "score", "person", "targets", "bye"];

/**
 * Opens a connection and keeps it open.
 * @param {string|URL} [url] of the service or its stream, http or ws; where this module came from unless given
 * @param {Options} [options]
 * @returns {Connection}
 */
export function connect(url, options = {}) {
  return new Connection(url, options);
}

/** One pointing session, opened again whenever it is lost. */
export class Connection {
  /** @type {State} */ state = "connecting";
  /** The newest `welcome`. @type {Welcome|null} */ welcome = null;
  /** Newest time from sending events to receiving their prediction, ms. @type {number|null} */ delayMs = null;
  /** Events sent to the service. */ sent = 0;
  #url; #options; #wishes; #socket = null; #listeners = new Map(NAMES.map((name) => [name, new Set()]));
  #waiting; #unanswered = []; #tries = 0; #openedAt = 0; #saidAt = 0; #retry; #why = ""; #met = false; #warned = false;
  #told = NO_TARGETS; #over = 0; #count = 0; #likely = []; #pointer = null; #targets; #person;
  #newest = -Infinity; #passedAt = -Infinity; #waits = false; #scrolled = false; // of events, s, ms; whether the service waits for one
  #entry; #choices; #proposals = new Proposals((choice) => this.#emit("choice", this.#named(choice)));
  #stop = new AbortController(); #alive;

  /** Use `connect`. @param {string|URL|undefined} url @param {Options} options */
  constructor(url, options) {
    this.#options = { predictor: "kinematic-adaptive", reply: "frame", encoding: "binary", element: window, pointer: true,
      coordinates: "client", targets: [], queue: 8192, ...given(options) };
    this.#url = url;
    this.#waiting = new Queue(this.#options.queue);
    const { predictor, parameters = {}, device, reply, encoding, assist } = this.#options;
    const screen = { width_px: window.screen?.width || undefined, height_px: window.screen?.height || undefined,
      ...this.#options.screen };
    this.#wishes = new Wishes({ type: "hello", version: 1, predictor, parameters, device, screen, reply, encoding, assist });
    this.#person = new Person(this.#options.person ?? "", predictor, {
      say: (message) => this.#transmit(JSON.stringify(message)),
      changed: (person) => this.#emit("person", { type: "person", person }) });
    const { element, pointer, coordinates, targets } = this.#options;
    const onScreen = coordinates === "screen", { signal } = this.#stop;
    if (pointer) this.#pointer = new PointerStream(element, { onScreen, passed: (rows) => this.#pass(rows), signal });
    const offset = () => (onScreen && this.#pointer?.offset) || [0, 0];
    this.#targets = new TargetWatch(targets, { offset, changed: (scrolled) => this.#look(scrolled), signal });
    this.#entry = new Entry(element, { pointer, observed: (one) => this.#targets.id(one), left: () => this.#wait(),
      proposals: this.#proposals, signal });
    this.#choices = new ServiceChoices(this.#proposals, this.#entry);
    window.addEventListener("online", () => this.state === "waiting" && this.#open(), { signal });
    this.#alive = setInterval(() => this.#keepAlive(), 1000);
    this.#open();
  }

  /** The id of the target that was proposed last and still is. @returns {string|null} */
  get proposed() {
    return this.#proposals.newest;
  }

  /** Events that gave way because there was no connection for too long, or a slow one. @returns {number} */
  get dropped() {
    return this.#waiting.dropped;
  }

  /**
   * Calls `listener` with every message of that name from now on.
   * @template {keyof Messages} Name
   * @param {Name} name @param {(message: Messages[Name]) => void} listener
   * @returns {() => void} call it to hear no more
   */
  on(name, listener) {
    const listeners = this.#listeners.get(name);
    if (!listeners) throw new TypeError(`unknown event ${name}; known: ${NAMES.join(", ")}`);
    listeners.add(listener);
    return () => listeners.delete(listener);
  }

  /**
   * Sends events: one message, or several where the limits of the service say so.
   * @param {(EventRow|EventRecord)[]} events in the order of their times; equal times are normal
   */
  send(events) {
    this.#pointer?.flush();
    if (events.length) this.#pass(events.map(row));
  }

  #pass(rows) {
    this.#targets.stir();
    if (this.#waits) this.#entry.alone = this.state !== "open";
    [this.#waits, this.#scrolled, this.#passedAt] = [false, false, performance.now()];
    if (this.#speaks) this.#sendRows(rows);
    else this.#keep(rows);
  }

  /** The pointer has left, or the page has moved under it: what the service proposed is of the past until the next event. */
  #wait() {
    this.#pointer?.flush();
    if (!this.#speaks || this.#waits) return;
    this.#waits = true;
    this.#choices.wait(this.#newest);
  }

  /** Whether what is sent now goes out: a socket that ends lets it fall. */
  get #speaks() {
    return this.state === "open" && this.#socket.readyState === WebSocket.OPEN;
  }

  /** Replaces the targets given by hand; those of `observe` stay. @param {Target[]} list */
  targets(list) {
    this.#targets.give(list);
  }

  /**
   * Registers an element as a target and follows it: within a frame while the pointer moves or something scrolls or
   * changes its size, otherwise within a quarter of a second. It is a target while a part of it is in view.
   * @param {Element} element @param {string} [id] the element's own id unless given
   * @returns {string} the id
   */
  observe(element, id) {
    const known = this.#targets.observe(element, id);
    this.#entry.look();
    return known;
  }

  /** Forgets an element. @param {Element} element */
  unobserve(element) {
    this.#targets.unobserve(element);
    this.#entry.look();
  }

  /**
   * How likely the pointer is heading for a target: its share in the newest prediction, 0 beyond the likeliest five. With
   * `encoding: "binary"` shares come with choices only: of what is proposed, when it was.
   * @param {Element|string} target an observed element, or an id @returns {number} 0 to 1
   */
  probability(target) {
    const likely = this.#wishes.encoding === "binary" ? this.#choices.standing : this.#likely;
    return likely.find(({ id, element }) => id === target || (element && element === target))?.p ?? 0;
  }

  /**
   * Says that a movement starts or has ended; the end is answered by `score`.
   * @param {"start"|"end"} action @param {Goal|Element} [target] the true one, where it is known
   */
  trial(action, target) {
    const goal = target instanceof Element ? this.#targets.goal(target) : target;
    this.#tell(goal ? { type: "trial", action, target: goal } : { type: "trial", action });
  }

  /**
   * Changes what is given; another predictor or other parameters begin without memory. Answered by `welcome`.
   * Another token is shown when the connection is next opened.
   * @param {{token?: string, predictor?: string, parameters?: Object<string, number|string|boolean>, reply?: "frame"|"event",
   *   precision?: number, assist?: Options["assist"]}} changes
   */
  configure({ token = this.#options.token, ...changes }) {
    this.#pointer?.flush();
    this.#options.token = token;
    const greeting = this.state === "connecting" && this.#socket?.readyState === WebSocket.OPEN; // hello is said
    if (this.state === "open" && Object.keys(changes).length) this.#ask(changes);
    else if (greeting) this.#wishes.ask(changes);
    else this.#wishes.hold(changes);
    if (this.state === "refused") this.#open();
  }

  #ask(changes) {
    this.#wishes.ask(changes);
    this.#transmit(JSON.stringify({ type: "configure", ...changes }));
  }

  /**
   * Asks what finished movements taught of the person: a short string for `person` of another connection, "" for nobody.
   * Without a session it is what the client heard last. With `known` the session begins anew knowing that; "" forgets
   * the person. The movement that goes on is not in it: `reset()` finishes it.
   * @param {string} [known] @returns {Promise<string>} rejects where the service does not take `known`
   */
  async person(known) {
    this.#pointer?.flush();
    if (this.#speaks) {
      if (known !== undefined) this.#unanswered = [];
      return this.#person.ask(known);
    }
    if (known !== undefined) this.#person.hold(known, this.#wishes.predictor);
    return this.#person.known;
  }

  /** Forgets every event: the next one starts a movement. */
  reset() {
    this.#unanswered = [];
    this.#tell({ type: "reset" });
  }

  /** Ends the session for good, and lets go of everything. */
  close() {
    if (this.state === "closed") return;
    this.#pointer?.flush();
    const socket = this.#socket;
    this.#socket = null;
    this.#stop.abort();
    clearInterval(this.#alive);
    clearTimeout(this.#retry);
    if (this.#openedAt < Infinity) socket?.send(JSON.stringify({ type: "bye" }));
    if (socket?.readyState === WebSocket.CONNECTING) socket.onopen = () => socket.close(1000); // sooner, a browser complains
    else socket?.close(1000);
    this.#person.lost();
    this.#proposals.clear();
    this.#become("closed");
  }

  #open() {
    clearTimeout(this.#retry);
    this.#why = "";
    this.#met = false;
    this.#openedAt = Infinity;
    this.#become("connecting");
    if (this.state !== "connecting") return; // closed by who heard of it
    const socket = new WebSocket(address(this.#url, this.#options.token), SUBPROTOCOL);
    socket.binaryType = "arraybuffer";
    const mine = (act) => (event) => socket === this.#socket && act(event);
    socket.onopen = mine(() => {
      this.#met = true;
      socket.send(this.#wishes.hello(this.#person.hello(this.#wishes.predictor)));
    });
    socket.onmessage = mine(({ data }) => this.#receive(data));
    socket.onclose = mine(() => this.#lost());
    this.#socket = socket;
  }

  #lost() {
    if (performance.now() - this.#openedAt > STEADY_MS) this.#tries = 0;
    this.#socket = null;
    this.#unanswered = [];
    this.#wishes.lost();
    this.#person.lost();
    this.#waits = false;
    this.#choices.lose();
    this.#likely = [];
    if (this.#why === "unauthorized" || this.#why === "hello") return this.#become("refused");
    if (this.#why === "idle" && this.#waiting.length === 0) return this.#become("idle");
    const wait = Math.min(LONGEST_WAIT_MS, FIRST_WAIT_MS * 2 ** this.#tries++) * (0.75 + 0.5 * Math.random());
    this.#retry = setTimeout(() => this.#open(), wait);
    this.#become("waiting");
    if (!this.#met) this.#inquire(address(this.#url, this.#options.token));
  }

  /** A page whose origin is not allowed stops trying, and says which flag allows it. */
  async #inquire(stream) {
    if (this.welcome && own(stream)) return;
    const message = await refusal(stream);
    const trying = this.state === "waiting" || (this.state === "connecting" && !this.#met);
    if (this.#why === "unauthorized" || !trying) return;
    const heard = message !== null && this.#listeners.get("error").size > 0; // who listens says it where he likes
    if (!heard && (this.welcome === null || message !== null)) this.#warn(unconnected(stream, message));
    if (message === null) return;
    this.#why = "unauthorized";
    clearTimeout(this.#retry);
    this.#emit("error", { type: "error", code: "unauthorized", message, path: null, recoverable: false });
    if (this.state === "waiting") this.#become("refused"); // one that tries again ends there by itself
  }

  /** Once for each connection, however often it tries. */
  #warn(words) {
    if (!this.#warned) console.warn(words);
    this.#warned = true;
  }

  #receive(data) {
    if (data instanceof ArrayBuffer) {
      for (const prediction of decode(data)) this.#predicted(prediction);
      return;
    }
    const message = JSON.parse(data);
    if (message.type === "prediction") return this.#predicted({ region: null, phase: null, remaining_s: null, ...message });
    if (message.type === "choice") return this.#choices.take(this.#named(message));
    if (message.type === "person") return this.#person.heard(message.person, this.welcome.predictor);
    if (message.type === "welcome") this.#greeted(message);
    if (message.type === "error") this.#refused(message);
    if (this.#listeners.has(message.type)) this.#emit(message.type, message);
  }

  /** With the observed element that an id stands for. */
  #named(one) {
    const element = this.#targets.element(one.id);
    return element === undefined ? one : { ...one, element };
  }

  #predicted(prediction) {
    this.#choices.confirm(prediction.t);
    if (prediction.targets) prediction.targets = this.#likely = prediction.targets.map((one) => this.#named(one));
    const answered = this.#unanswered;
    while (answered.length && answered[0].t < prediction.t) answered.shift();
    if (answered.length && answered[0].t === prediction.t) this.delayMs = performance.now() - answered.shift().at;
    this.#emit("prediction", prediction);
  }

  #greeted(message) {
    this.welcome = message;
    if (this.state === "open") return this.#wishes.granted();
    this.#openedAt = performance.now();
    for (const changes of this.#wishes.late) this.#ask(changes);
    this.#person.greeted();
    this.#told = NO_TARGETS;
    this.#sendTargets();
    if (this.#socket === null) return; // closed by who heard of an error
    for (const { rows, message: kept } of this.#waiting.take(message.limits, this.#count)) {
      if (rows) {
        this.#choices.past(rows.at(-1)[0]);
        this.#sendRows(rows);
      } else this.#transmit(JSON.stringify(kept));
    }
    this.#entry.alone = false;
    this.#become("open");
  }

  #refused({ code, path, message }) {
    this.#why = code;
    if (path === "$.person") return this.#forget(message);
    if (this.state === "connecting" && (code === "unknown_predictor" || code === "bad_field")) {
      this.#why = "hello";
      const socket = this.#socket;
      this.#lost();
      socket.close(1000);
    } else if (code === "unknown_predictor" || /^\$\.(predictor|parameters|reply|precision|assist)/.test(path ?? "")) {
      this.#wishes.refused();
    }
  }

  /** The service does not take the person: a session begins without, one that is open knows whom it knew. */
  #forget(message) {
    if (this.state !== "connecting") return this.#person.refused(message);
    const socket = this.#socket;
    this.#person.hold("");
    this.#lost();
    socket.close(1000);
  }

  #sendRows(rows) {
    const { limits } = this.welcome;
    this.#newest = rows.at(-1)[0];
    for (const { frame, last, count } of frames(rows, this.#wishes.encoding, limits)) {
      if (this.#socket.bufferedAmount > MOST_BUFFERED) {
        this.#waiting.dropped += count;
        continue;
      }
      this.#transmit(frame);
      this.sent += count;
      this.#unanswered.push({ t: last, at: performance.now() });
      if (this.#unanswered.length > 4096) this.#unanswered.shift();
    }
  }

  #tell(message) {
    this.#pointer?.flush();
    if (this.#speaks) this.#transmit(JSON.stringify(message));
    else this.#keep([message]);
  }

  #transmit(frame) {
    this.#saidAt = performance.now();
    this.#socket.send(frame);
  }

  #keep(items) {
    if (this.state === "closed") throw new Error("the connection is closed");
    this.#waiting.keep(items);
    if (this.state === "idle") this.#open();
  }

  /** A page that is looked at keeps its session; a hidden one lets it go and opens another with the next event. */
  #keepAlive() {
    if (this.#speaks) this.#person.refresh(this.sent);
    if (this.state !== "open" || document.hidden) return;
    if (performance.now() - this.#saidAt < (1000 * this.welcome.limits.idle_s) / 3) return;
    this.#sendTargets(true);
  }

  /** Elements may have moved; where that is by scrolling or a new size, nothing else says so to a pointer that rests. */
  #look(scrolled) {
    if (this.#sendTargets() && scrolled) this.#scrolled = true;
    if (this.#scrolled && performance.now() - this.#passedAt > REST_MS) this.#wait();
  }

  /** @returns {boolean} whether the service is told of a change */
  #sendTargets(always = false) {
    if (this.#socket?.readyState !== WebSocket.OPEN || this.#openedAt === Infinity) return false; // not greeted
    const { text, over, count } = targetsFrame(this.#targets.list(), this.welcome.limits);
    if (text === this.#told && !always) return false;
    [this.#told, this.#count] = [text, count];
    if (count === 0) this.#likely = [];
    this.#transmit(text);
    const said = this.#over;
    this.#over = over;
    const message = `${over} targets beyond the first ${count} were left out: the service takes no more`;
    if (over > said) this.#emit("error", { type: "error", code: "too_many", message, path: "$.targets", recoverable: true });
    return true;
  }

  #become(state) {
    if (state === this.state) return;
    this.state = state;
    this.#emit("state", state);
  }

  #emit(name, message) {
    for (const listener of this.#listeners.get(name)) {
      try {
        listener(message);
      } catch (error) {
        reportError(error); // one listener's mistake is shown, and is not another's
      }
    }
  }
}

/** Options without those that are undefined: they are as if not given. */
const given = (options) => Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined));
