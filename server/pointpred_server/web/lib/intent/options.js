// What may be said in options: defaults, kinds of values and bounds.

/**
 * The options with their defaults. Throws a TypeError for one that is unknown or of another type, a RangeError for a number
 * out of bounds.
 * @param {object|null|undefined} given undefined values count as not given @param {Object<string, any>} defaults
 * @param {Object<string, (string|number)[]>} known what an option may be: one of some words or kinds of values, or a number between two
 * @returns {any}
 */
export function checked(given, defaults, known) {
  const options = { ...defaults };
  for (const [name, value] of Object.entries(given ?? {})) {
    if (!Object.hasOwn(options, name))
      throw new TypeError(`unknown option ${name}; known: ${Object.keys(options).join(", ")}`);
    if (value !== undefined) options[name] = value;
  }
  for (const [name, values] of Object.entries(known)) {
    const value = options[name];
    if (typeof values[0] === "number") checkNumber(name, value, /** @type {number[]} */ (values));
    else if (value !== undefined && !values.includes(value) && !values.includes(`a ${typeof value}`))
      throw new TypeError(`${name} must be ${values.join(" or ")}, received ${value}`);
  }
  return options;
}

/** @param {string} name @param {unknown} value @param {number[]} bounds */
export function checkNumber(name, value, [low, high]) {
  if (!(typeof value === "number" && value >= low && value <= high))
    throw new RangeError(`${name} must be a number in [${low}, ${high}], received ${value}`);
}
