// Types of the npm package `pointpred`.

import type { OwnParameters, PredictorName, SharedParameters } from "./laws/parameters.js";

export type { PredictorName };

/** Why it fired. */
export type Reason =
  /** The movement of the pointer heads for the element. */
  | "predicted"
  /** The pointer has gone into it. */
  | "entered"
  /** It has the keyboard focus. */
  | "focus"
  /** A few presses of Tab reach it. */
  | "tab"
  /** A finger was put on it. */
  | "touch"
  /** It came into view on a device that cannot hover. */
  | "viewport"
  /** A scroll is about to bring it under the pointer, or into view. */
  | "scroll";

/** px beyond each side. */
export interface Sides {
  top?: number;
  right?: number;
  bottom?: number;
  left?: number;
}

export interface IntentOptions {
  /**
   * `"prefetch"` (default): fires early where the probability is high enough for the threshold, for several elements at once, and when
   * the pointer enters an element at the latest; nothing is withdrawn.
   * `"highlight"`: fires for the element that is likeliest, and for the one that the pointer is in; ends when that is over.
   */
  policy?: "prefetch" | "highlight";
  /**
   * How likely it must be that the pointer goes to the element (prefetch: through it), in (0, 1]; 0.5 by default. Higher fires later
   * and less often; at 1 a prefetch fires at entry only. If an element has several registrations, the lowest counts.
   */
  threshold?: number;
  /** Whether it fires at all, asked each time it would; true by default. It stays registered meanwhile. */
  enabled?: boolean | ((element: Element) => boolean);
  /** Whether it fires only once; true by default for prefetch. Otherwise once in each movement. */
  once?: boolean;
  /** After so many seconds it may fire again, also with `once`; never by default. */
  again_s?: number;
  /** How long the pointer must have been in it to fire for that, s; 0 by default. A prediction does not wait. */
  dwell_s?: number;
  /** How far beyond its sides the element counts, px; 0 by default. */
  hitSlop?: number | Sides;
  /** Weight before the pointer moves; other elements have 1. 0 never fires. */
  priority?: number;
  /** Its name in the ledger; the element's id by default, and of a link of `prefetchLink` without one the path of its page. */
  name?: string;
  /**
   * A name of the registry of predictors: `"kinematic-adaptive"` by default; `"minimum-jerk"` and `"switched-direction"` are small.
   * The default is loaded when the page is idle. Until then `"minimum-jerk"` predicts, to the end of a movement.
   */
  predictor?: PredictorName;
  /** The address of a service that predicts instead of the page. */
  service?: string;
  /** Prefetch what so many presses of Tab reach; 2 by default, 0 for none. The focus itself always counts. */
  keyboard?: number;
  /** Fingers: fire when one is put on the element (default), when it comes into view on a device that cannot hover, or not. */
  touch?: "start" | "viewport" | "none";
  /** Scrolls: fire when the element is about to come under the pointer that rests (default), or into view, or not. */
  scroll?: "pointer" | "view" | "none";
  /** `"respect"` (default): no prefetch while the user saves data or has a 2G connection. */
  saveData?: "respect" | "ignore";
  /**
   * Marks the element for style sheets as long as a firing holds (a prefetch: until it is stopped): `data-target` with the reason, and
   * `data-predicted` where that is `"predicted"`; false by default.
   */
  attributes?: boolean;
  /** Is called with what the page's own functions throw or reject with, instead of the console; `firing` null if none holds. */
  onError?: (error: unknown, firing: Firing | null) => void;
}

/** What a callback is given. */
export interface Firing {
  element: Element;
  name: string;
  policy: "prefetch" | "highlight";
  reason: Reason;
  /** The probability that the movement is for this element; 1 where it is certain. */
  p: number;
  /**
   * What was compared with `threshold` to predict: how likely the pointer goes through the element soon (prefetch), or to it and not to
   * something that is not registered (highlight); null for other reasons.
   */
  score: number | null;
  /** The lowest of the element; null for other reasons. */
  threshold: number | null;
  /** When, s since the page was opened. */
  t: number;
  /** The predicted time until the pointer arrives, s; null where none is predicted. */
  remaining_s: number | null;
  /** Is aborted when a highlight ends, before the registration fires again, and when it stops. */
  signal: AbortSignal;
}

/** May return a function, or a promise of one, which is called when the signal of the firing is aborted. */
export type IntentCallback = (firing: Firing) => unknown;

/** What a directive or an action of a framework takes: a callback, or a callback with options; with nothing to call the element is not registered. */
export type IntentBinding = IntentCallback | (IntentOptions & { callback: IntentCallback }) | null | undefined;

/** A registered element. */
export interface Handle {
  readonly element: Element;
  /**
   * Resolves when the predictor is loaded, or its service has answered; rejects if the predictor cannot be loaded. Before, elements
   * fire at entry only; before the default predictor is loaded, `"minimum-jerk"` predicts.
   */
  readonly ready: Promise<void>;
  /** The probability that the movement is for this element, 0 while it is not in view. */
  readonly share: number;
  /** Stops it. */
  stop(): void;
}

/** Calls `callback` when the user is heading for an element, or for one of several, such as a NodeList. Returns what stops it. */
export function onIntent(
  elements: Element | Iterable<Element>,
  callback: IntentCallback,
  options?: IntentOptions,
): () => void;

/** Registers an element without a callback, so that its neighbours are predicted by mistake less often. */
export function register(element: Element, options?: IntentOptions): Handle;

export interface PrefetchLinkOptions extends Omit<IntentOptions, "policy"> {
  /** As of `onIntent`, but 0.065 by default: links that the pointer only crosses are not loaded. */
  dwell_s?: number;
  /** `"prefetch"` (default) or `"prerender"`, where the browser has Speculation Rules. */
  action?: "prefetch" | "prerender";
  /** The address of the page behind an element, which then need not be a link; nothing: none. Its `href` by default. */
  href?: (element: Element) => string | URL | null | undefined;
  /**
   * What is left out besides addresses that look as if they logged out or changed something, and all in an element with
   * `data-no-prefetch`: what a pattern finds in the address, or a function says so of.
   */
  ignore?: LinkFilter | readonly LinkFilter[];
  /** Other origins whose pages may be loaded, such as `"https://shop.example"`; `"*"`: all. None by default. Of an address its origin counts. */
  origins?: string | readonly string[];
  /** The most pages to load; no limit by default. */
  limit?: number;
  /**
   * The nonce of the page's Content Security Policy, so that Speculation Rules can be used; `""` where the policy allows them by
   * `'inline-speculation-rules'` or, without nonces and hashes, `'unsafe-inline'`. Without it a page with a policy uses `<link rel=prefetch>`, which needs
   * pages that may be cached, and a directive that allows their origin.
   */
  nonce?: string;
  /** Also take links that are added later; for a selector. False by default. */
  watch?: boolean;
}

/** What is ignored; the element is a link unless `href` is given. */
export type LinkFilter =
  | RegExp
  | ((element: HTMLAnchorElement | SVGAElement | HTMLAreaElement, address: URL) => boolean);

/** Loads the pages of links that the user is heading for: of one, of several, or of a selector. Returns what stops it. */
export function prefetchLink(links: Element | Iterable<Element> | string, options?: PrefetchLinkOptions): () => void;

export interface PlaceOptions {
  /** The share that a place must have to be proposed; 0.5 by default. */
  precision?: number;
  /** The name of the page, whose places these are; the path of its address by default. */
  page?: string;
  /** What was learned of the person before, as `person` of an earlier handle. */
  person?: string;
  /** Keep what is learned in `localStorage` under this name, also for the next visit; nothing is stored by default. */
  store?: string;
}

/** A place that the user is heading for, where movements ended before. */
export interface PlaceFiring {
  /** The same number as long as the place is remembered. */
  id: number;
  /** The centre of the square that visits of the place scatter in, and its side, px of the viewport. */
  place: { x: number; y: number; size: number };
  reason: "predicted" | "entered";
  p: number;
  t: number;
  remaining_s: number | null;
  /** Is aborted when the place is no longer proposed. */
  signal: AbortSignal;
}

export interface PlaceHandle {
  /** Resolves when the predictor is loaded. */
  readonly ready: Promise<void>;
  /** What finished movements have taught of the person. */
  readonly person: string;
  /** Forgets the person, here and in what was stored. */
  forget(): void;
  /** Stops it; what was learned is stored where a name was given. */
  stop(): void;
}

/** Calls `callback` when the user is heading for a place where movements ended before: nothing is registered. It may return a function, which is called when that is over. */
export function onPlace(callback: (firing: PlaceFiring) => unknown, options?: PlaceOptions): PlaceHandle;

/** `fired`: calls of callbacks; `hit`: those whose element, or page, was used afterwards; `wasted`: the others so far. */
export interface Firings {
  fired: number;
  hit: number;
  wasted: number;
}

export interface Counts extends Firings {
  /** Firings left out to save data. */
  withheld: number;
  /** Highlights that have ended. */
  withdrawn: number;
  /** From firing to activation, s, of the newest 1,000 hits; null where there is none. */
  lead_s: { count: number; least: number | null; median: number | null; most: number | null };
  /** The same by the reason, of those that there were. */
  reasons: { [reason in Reason]?: Firings };
}

export interface LedgerSummary extends Counts {
  names: Record<string, Counts>;
}

export interface LedgerEntry extends Omit<Firing, "element" | "remaining_s" | "signal"> {
  /** Null if it has gone meanwhile. */
  element: Element | null;
  kind: "fired" | "hit" | "withheld" | "withdrawn";
  /** Of a hit. */
  lead_s: number | null;
}

/** What has fired so far: hits, unused firings and lead times. */
export function ledger(): LedgerSummary;

/** Calls `listener` with each entry of the ledger from now on. Returns what stops it. */
export function onLedger(listener: (entry: LedgerEntry) => void): () => void;

/** Shows developers what is predicted. Resolves to what hides it. */
export function showOverlay(): Promise<() => void>;

/** t s, x y px, y down; dx dy: counts of the device; buttons as in pointer events. */
export interface PointerSample {
  t: number;
  x: number;
  y: number;
  dx?: number | null;
  dy?: number | null;
  buttons?: number;
}

export interface PredictionInPage {
  t: number;
  x: number;
  y: number;
  /** [sxx, sxy, syy] px². */
  scale: number[] | null;
  covariance: number[] | null;
  region: { sxx: number; sxy: number; syy: number; tail: number | null } | null;
  tail: number | null;
  phase: "still" | "ballistic" | "corrective";
  remaining_s: number | null;
  remaining_spread: number | null;
}

/** x y px; p: how likely it is the destination now, before: before the movement showed anything; spread: standard deviation of visits, px. */
export interface Place {
  x: number;
  y: number;
  p: number;
  before: number;
  visits: number;
  id: number;
  spread: number;
}

/** What can be pointed at: its upper left corner and size, px. */
export interface Target {
  id: unknown;
  x: number;
  y: number;
  width: number;
  height: number;
  /** How likely it is before the pointer moves, relative to the others; 1 by default, 0 never. */
  weight?: number;
  /** What it is to the user, such as `"button"`: what is taken of a kind is learned. */
  kind?: string;
}

/** The law of the endpoint: one of the parts holds, each with its share; elsewhere first. */
export interface Mixture {
  /** x y px; scale: [sxx, sxy, syy] px² of a Student law with `tail` degrees of freedom, or of a normal one (null). */
  readonly parts: { share: number; x: number; y: number; scale: number[]; tail: number | null }[];
  /** The outlines of the smallest region that holds the endpoint with probability `level`: closed polygons, px. */
  outlines(level: number): [number, number][][];
}

/** Consumes events one by one. */
export interface Pipeline {
  readonly name: string;
  /** What finished movements taught of the person. */
  readonly person: string;
  /** Where movements of the person ended before, the likeliest destination first. */
  readonly places: Place[];
  /** How likely the movement is for each registered target, by its id; null: for none of them. */
  readonly shares: Map<unknown, number>;
  /** What the last prediction knows beyond one law: the targets and places where it may end; null where it knows no more. */
  readonly mixture: Mixture | null;
  /**
   * Takes these targets in place of those before, at most 1000; none: as if nobody had. Endpoint, region and time left are then
   * those of a movement to one of them or elsewhere.
   */
  register(targets: readonly Target[]): void;
  update(event: PointerSample): PredictionInPage | null;
  /** The next movement is in this window, with its origin at x and y, px; one that goes on stays where it began. */
  enter(key: string, x?: number, y?: number): void;
  /** Forgets the person. */
  forget(): void;
  reset(): void;
  fresh(): Pipeline;
}

/** What can be set of a pipeline: the parameters of its predictor and of its differentiator, and more. */
export type BuildOptions<Name extends PredictorName = PredictorName> = SharedParameters &
  OwnParameters[Name] & {
    /** What can be pointed at. */
    targets?: readonly Target[];
    /** What `person` of an earlier pipeline of this name was. */
    person?: string;
  };

/** A pipeline by its name in the registry. */
export function build<Name extends PredictorName>(name: Name, options?: BuildOptions<Name>): Promise<Pipeline>;

export interface Ellipse {
  x: number;
  y: number;
  major: number;
  minor: number;
  angle: number;
}

/** The ellipse that holds the endpoint with probability `level`; null where no region is claimed. */
export function regionOf(prediction: object | null | undefined, level: number): Ellipse | null;

/** An event in a row: t s, x px, y px, counts, buttons. */
export type EventRow = [number, number, number, number | null, number | null, number];

/** A target of a connection. */
export type NamedTarget = Target & { id: string };

/** The true target of a movement: its centre and width, px. */
export type Goal = { x: number; y: number; width: number };

/**
 * `waiting`: will try again; `idle`: the service has ended a session without events, the next event opens another; `refused`: waits for
 * `configure()`; `closed`: for good.
 */
export type State = "connecting" | "open" | "waiting" | "idle" | "refused" | "closed";

/** null: there is no prediction now. */
export interface Prediction {
  type: "prediction";
  t: number;
  x: number | null;
  y: number | null;
  region: { sxx: number; sxy: number; syy: number; tail: number | null } | null;
  phase: "still" | "ballistic" | "corrective" | null;
  remaining_s: number | null;
  /** Standard deviation of the logarithm of `remaining_s`. */
  remaining_spread: number | null;
  /** The id of the target that is likeliest of all; null: none of them is. */
  target?: string | null;
  /** The likeliest five, with encoding `"json"`; `element`: the observed one. */
  targets?: { id: string; p: number; element?: Element }[];
}

/** Where the service has moved the cursor, px, and how far assistance has moved it since the session began. */
export type Cursor = { type: "cursor"; t: number; x: number; y: number; added_px: number };

export interface Choice {
  type: "choice";
  id: string;
  p: number;
  action: "propose" | "retract";
  t: number | null;
  /**
   * Why it is proposed: the movement heads for it, the pointer has entered it, it has the keyboard focus, or a finger touches it; null
   * where it is retracted.
   */
  reason: "predicted" | "entered" | "focus" | "touch" | null;
  element?: Element;
  /** The centre and side of a place that nobody registered, px. */
  place?: { x: number; y: number; size: number };
}

export type ErrorMessage = {
  type: "error";
  code: string;
  message: string;
  path: string | null;
  field?: string | null;
  recoverable: boolean;
};

export interface Limits {
  max_frame_bytes: number;
  max_events_per_frame: number;
  max_events_per_s: number;
  max_targets: number;
  max_sessions: number;
  idle_s: number;
}

export type Welcome = { type: "welcome"; version: number; session: string; predictor: string; limits: Limits };

export interface Score {
  type: "score";
  events: number;
  time_averaged_px: number | null;
  hold_px: number | null;
  skill: number | null;
  by_time: Record<string, number>;
  by_path: Record<string, number>;
  reason: string | null;
  fired: number | null;
  hit: boolean | null;
  wasted: number | null;
  lead_s: number | null;
}

/** By the name of their event. */
export interface Messages {
  prediction: Prediction;
  cursor: Cursor;
  choice: Choice;
  error: ErrorMessage;
  state: State;
  welcome: Welcome;
  score: Score;
  /** What finished movements have taught about the person; "": nothing. */
  person: { type: "person"; person: string };
  targets: { type: "targets"; count: number };
  bye: { type: "bye"; reason: string };
}

/** A connection to a service, of `connect`; its calls are described in the guide of the browser client. */
export class Connection {
  private constructor();
  readonly state: State;
  /** The newest `welcome`. */
  readonly welcome: Welcome | null;
  /** The newest time from sending events to receiving their prediction, ms. */
  readonly delayMs: number | null;
  /** Events sent to the service. */
  readonly sent: number;
  /** Events dropped because there was no connection for too long, or a slow one. */
  readonly dropped: number;
  /** The id of the target that was proposed last and still is. */
  readonly proposed: string | null;
  on<Name extends keyof Messages>(name: Name, listener: (message: Messages[Name]) => void): () => void;
  send(events: readonly (EventRow | PointerSample)[]): void;
  observe(element: Element, id?: string): string;
  unobserve(element: Element): void;
  /** The law of the endpoint by targets, places and elsewhere, where the page predicts; null where the service does. */
  readonly mixture: Mixture | null;
  targets(list: readonly NamedTarget[]): void;
  probability(target: Element | string): number;
  trial(action: "start" | "end", target?: Element | Goal | null, conditions?: Record<string, string | number>): void;
  configure(
    changes: Pick<ConnectOptions, "token" | "predictor" | "parameters" | "reply" | "assist" | "places"> & {
      precision?: number;
    },
  ): void;
  person(known?: string): Promise<string>;
  /** The next movement is in this window or page, with its origin at x and y, px. */
  enter(key: string, x?: number, y?: number): void;
  forget(): Promise<string>;
  reset(): void;
  close(): void;
}

export interface ConnectOptions {
  /** `"kinematic-adaptive"` by default. A service may know more of them. */
  predictor?: PredictorName | (string & {});
  /** Of the predictor and its differentiator. */
  parameters?: Record<string, number | string | boolean>;
  device?: { cpi?: number; rate_hz?: number };
  /** 96 px per inch and this screen by default. */
  screen?: { width_px?: number; height_px?: number; dpi?: number };
  /** One prediction per message (default), or one per event. */
  reply?: "frame" | "event";
  encoding?: "binary" | "json";
  /** The service moves the cursor by the counts of events, assisted; needs `device.cpi` and counts. */
  assist?: { strength?: number; rho?: number; function?: "constant" | "sigmoid"; gain?: number };
  /** What an earlier session has learned about the person. */
  person?: string;
  /** Places where the person went before are proposed, while there are no targets. */
  places?: boolean;
  /** If the service asks for one. */
  token?: string;
  /** Predictions are made in the page, without a service. */
  page?: boolean;
  /** Whose pointer events are streamed; the window by default. */
  element?: EventTarget;
  /** `false`: only events passed to `send` are streamed. */
  pointer?: boolean;
  coordinates?: "client" | "screen";
  targets?: readonly NamedTarget[];
  /** Events kept while there is no connection; 8192 by default. */
  queue?: number;
}

/** Opens a connection to a service and keeps it open. */
export function connect(url?: string | URL, options?: ConnectOptions): Connection;
