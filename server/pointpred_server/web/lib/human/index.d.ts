/** A place in the viewport: of a rectangle the upper left corner and the size, px. */
export interface Place {
  x: number;
  y: number;
  width?: number;
  height?: number;
}

/** An element of Playwright (a handle or a locator) or Puppeteer, or a reference to one in the W3C's protocol. */
export type PageElement = { boundingBox(): Promise<Place | null> } | { "element-6066-11e4-a52e-4f735466cecf": string };

/** A page of Playwright or Puppeteer. */
export interface MousePage {
  mouse: { move(x: number, y: number): Promise<unknown>; down(): Promise<unknown>; up(): Promise<unknown> };
  $(selector: string): Promise<{ boundingBox(): Promise<Place | null> } | null>;
  evaluate(expression: string): Promise<unknown>;
}

export interface HumanOptions {
  /** A whole number in [0, 2147483645]; 1 by default. The same seed makes the same movements. */
  seed?: number;
  /** From 0, a novice, to 1, an expert: slower with more corrections, or faster and straighter; 0.5 by default. */
  skill?: number;
  /** Where the pointer is, px of the viewport; the upper left corner by default. */
  at?: { x: number; y: number };
}

export interface Human {
  /**
   * Moves the pointer until it rests in an element (by its first match of a selector, or itself), a rectangle or at a point.
   * Rejects if there is none, or if its middle is not in the viewport.
   */
  moveTo(target: string | PageElement | Place): Promise<void>;
  /** Moves there, presses the button and releases it. */
  click(target: string | PageElement | Place): Promise<void>;
  /** Where the hand is, px of the viewport. */
  readonly at: { x: number; y: number };
}

/** A simulated hand for the mouse of a page, or of a WebDriver session by its address (`http://localhost:9515/session/...`). */
export function human(browser: MousePage | string | URL, options?: HumanOptions): Human;
