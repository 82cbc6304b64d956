// Runs the laws in JavaScript over streams of events, and compares every answer with that of Python.

/**
 * @typedef {{table: number[][], keys: number[][]}} Targets
 * @typedef {{name: string, differentiator: string, settings: object, rows: (number|null)[][], known: number[], targets: Targets|null,
 *   answers: (number|null)[][]}} Stream
 */

const PHASE = 7;
const CURSOR = 15; // numbers of a cursor's way
const KINDS = { place: [1, 2], scale: [3, 4, 5], left: [6], tail: [8, 9] }; // numbers of a prediction that share a unit

/** A stage: its laws and its memory. */
class Stage {
  constructor(kind, settings, coefficients) {
    const values = Float64Array.from(kind.parameters, (one) => settings[one.name] ?? one.default ?? one.absent);
    const [first, learned, states] = kind.sizes ? kind.sizes(values) : [kind.settings, kind.learned, kind.states];
    [this.kind, this.settings, this.first, this.coefficients] = [kind, first, first + learned, coefficients];
    this.memory = new Float64Array(first + learned + states);
    kind.fill(values, this.memory);
    kind.settle?.(this.memory);
  }

  step(row) {
    return this.coefficients ? this.kind.step(this.memory, row, this.coefficients) : this.kind.step(this.memory, row);
  }

  reset() {
    this.kind.conclude?.(this.memory);
    this.memory.fill(0, this.first);
  }
}

/** What can be pointed at: the laws that weigh it, and their memory. */
class Aim {
  constructor(law, heading, { table, keys }, coefficients) {
    const rows = table.map((row) => Float64Array.from(row));
    [this.law, this.heading, this.coefficients, this.memory] = [
      law,
      heading,
      coefficients,
      new Float64Array(heading.LENGTH),
    ];
    this.targets = [rows, Float64Array.from(rows, (row) => row[4]), keys, new Float64Array(rows.length + 1)];
    this.memory.set(law.Aim.parameters.map((one) => one.default));
    heading.begin(this.memory, this.targets);
  }

  step(event, answer) {
    return this.law.step(this.memory, event, answer, this.targets, this.coefficients);
  }

  reset() {
    this.law.conclude(this.memory, this.targets, this.coefficients);
    this.memory.fill(0, this.law.Aim.settings + this.law.Aim.learned);
    this.heading.begin(this.memory, this.targets);
  }
}

/** What weighs targets. @param {string} laws @param {Targets|null} targets @returns {Promise<Aim|null>} */
async function aimOf(laws, targets) {
  const [law, heading, { FITTED }] = await Promise.all(
    ["aim", "heading", "posterior"].map((name) => import(`${laws}/targets/${name}.js`)),
  );
  return targets && new Aim(law, heading, targets, FITTED);
}

const numbers = (row) => row.map((value) => (value === null ? NaN : value));
const isMissing = Number.isNaN;

/** How far two numbers are apart, over a size; infinite where only one of them is missing. */
function apart(one, other, size) {
  if (isMissing(one) || isMissing(other)) return isMissing(one) && isMissing(other) ? 0 : Infinity;
  return one === other ? 0 : Math.abs(one - other) / size;
}

/**
 * The furthest that the endpoints of a stream are from Python's, as a share of how far the movement or the prediction goes; of the
 * region its scale, as a share of its size; the time left, and the tail and the spread, as shares of themselves where they exceed 1;
 * and the events at which a phase or a refusal differs. Infinite where a number is missing on one side only.
 * @param {string} laws the folder of the laws @param {Stream} stream @param {Float64Array} coefficients
 */
export async function compare(laws, stream, coefficients) {
  const { PREDICTORS, DIFFERENTIATORS } = await import(`${laws}/registry.js`);
  const entry = PREDICTORS[stream.name];
  const differentiator = new Stage(await DIFFERENTIATORS[stream.differentiator].load(), stream.settings);
  const predictor = new Stage(await entry.load(), stream.settings, entry.coefficients ? coefficients : undefined);
  predictor.memory.set(stream.known, predictor.settings);
  const aim = await aimOf(laws, stream.targets);
  const worst = { place: 0, scale: 0, left: 0, tail: 0 },
    unequal = [];
  let start = null;
  stream.rows.forEach((row, i) => {
    if (row.length === 0) {
      // a reset
      differentiator.reset();
      predictor.reset();
      aim?.reset();
      start = null;
      return;
    }
    const event = numbers(row),
      expected = stream.answers[i] && numbers(stream.answers[i]);
    const before = differentiator.memory.slice();
    const motion = differentiator.step(event);
    let answer = motion[0] === motion[0] ? predictor.step(motion) : motion;
    if (aim && answer[0] === answer[0]) answer = aim.step(event, answer);
    if (answer[0] !== answer[0]) differentiator.memory.set(before);
    if ((answer[0] === answer[0]) !== Boolean(expected)) return unequal.push(i);
    if (!expected) return;
    start ??= event;
    if (Number(answer[PHASE]) !== expected[PHASE]) return unequal.push(i);
    const far = Math.max(
      1,
      ...KINDS.place.map((k) => Math.abs(event[k] - start[k])),
      ...KINDS.place.map((k) => Math.abs(expected[k] - event[k]) || 0),
    );
    const sizes = {
      place: () => far,
      scale: () => Math.abs(expected[3]) + Math.abs(expected[5]),
      left: (k) => Math.max(1, expected[k]),
      tail: (k) => Math.max(1, expected[k]),
    };
    for (const [kind, places] of Object.entries(KINDS))
      for (const k of places)
        worst[kind] = Math.max(worst[kind], apart(Number(answer[k]), expected[k], sizes[kind](k)));
  });
  return { name: stream.name, differentiator: stream.differentiator, ...worst, unequal };
}

/**
 * The same for targets: the furthest that a share is from Python's, and the events at which a decision differs.
 * @param {string} laws @param {Targets & {settings: number[], events: (number|null)[][], answers: (number|null)[][], shares: number[][],
 *   decisions: number[][], account: number[], thresholds: number[], fired: number[][]}} given
 */
export async function compareTargets(laws, given) {
  const [choice, account, prefetch] = await Promise.all(
    ["choice_law", "ledger", "prefetch"].map((name) => import(`${laws}/targets/${name}.js`)),
  );
  const aim = await aimOf(laws, given),
    [table, , keys, shares] = aim.targets,
    count = table.length,
    unequal = [];
  const state = new Float64Array(2).fill(-1),
    changes = new Float64Array(4),
    counts = new Float64Array(account.STATES);
  const rows = Array.from({ length: 60 }, () => new Float64Array(account.FIELDS));
  const targets = [table, new Float64Array(count), shares],
    memory = new Float64Array(prefetch.STATES);
  const prefetched = [table, Float64Array.from(given.thresholds), new Float64Array(count), new Float64Array(count)];
  let worst = 0;
  account.drop(counts);
  given.events.forEach((event, i) => {
    aim.step(numbers(event), numbers(given.answers[i]));
    const changed = choice.update(state, aim.memory, targets, keys, given.settings, counts, rows, changes);
    if (String([...state, ...(changed ? changes : [])]) !== String(given.decisions[i])) unequal.push(i);
    memory.set(aim.memory.subarray(aim.heading.CURSOR, aim.heading.CURSOR + CURSOR));
    prefetch.step(memory, prefetched, shares, prefetch.FITTED);
    if (String(prefetched[3]) !== String(given.fired[i])) unequal.push(i);
    for (let k = 0; k <= count; k++) worst = Math.max(worst, Math.abs(shares[k] - given.shares[i][k]));
  });
  counts.forEach((value, i) => {
    worst = Math.max(worst, Math.abs(value - given.account[i]) || 0);
  });
  return { worst, unequal };
}

/** All comparisons of one file of cases. @param {string} laws @param {{streams: Stream[], targets: object}} cases */
export async function compareAll(laws, cases) {
  const { COEFFICIENTS } = await import(`${laws}/kinematic.js`);
  const streams = [];
  for (const stream of cases.streams) streams.push(await compare(laws, stream, COEFFICIENTS));
  return { streams, targets: await compareTargets(laws, cases.targets) };
}
