// The digest of a person and of a window's name: BLAKE2b (RFC 7693, without a key), on pairs of 32-bit words.

const BLOCK = 128;
/** The initial values, the lower half of each before its upper half. */
const INITIAL = Uint32Array.from(
  [
    "f3bcc908 6a09e667 84caa73b bb67ae85 fe94f82b 3c6ef372 5f1d36f1 a54ff53a",
    "ade682d1 510e527f 2b3e6c1f 9b05688c fb41bd6b 1f83d9ab 137e2179 5be0cd19",
  ].flatMap((line) => line.split(" ")),
  (half) => Number.parseInt(half, 16),
);
/** The order in which the words of a block are mixed in, one line a round. */
const ORDER = [
  "0123456789abcdef",
  "ea489fd61c02b753",
  "b8c052fdae367194",
  "7931dcbe265a40f8",
  "905724afe1bc683d",
  "2c6a0b834d75fe19",
  "c51fed4a0763928b",
  "db7ec13950f4862a",
  "6fe9b308c2d714a5",
  "a2847615fb9e3cd0",
  "0123456789abcdef",
  "ea489fd61c02b753",
].map((line) => Array.from(line, (digit) => 2 * Number.parseInt(digit, 16)));
/** The words that are mixed together in each round: columns, then diagonals. */
const QUARTERS = ["048c", "159d", "26ae", "37bf", "05af", "16bc", "278d", "349e"].map((line) =>
  Array.from(line, (digit) => 2 * Number.parseInt(digit, 16)),
);

/** words[a] += low + 2^32 high, where words[a] and words[a + 1] are the halves of a number. */
function add(words, a, low, high) {
  const sum = words[a] + low;
  words[a] = sum;
  words[a + 1] += high + (sum > 0xffffffff ? 1 : 0);
}

/** words[a] = (words[a] ^ words[b]) turned right by `bits`. */
function turn(words, a, b, bits) {
  let low = words[a] ^ words[b],
    high = words[a + 1] ^ words[b + 1];
  if (bits >= 32) [low, high] = [high, low];
  const rest = bits % 32;
  words[a] = rest ? (low >>> rest) | (high << (32 - rest)) : low;
  words[a + 1] = rest ? (high >>> rest) | (low << (32 - rest)) : high;
}

/** @param {Uint32Array} words @param {number[]} quarter @param {Uint32Array} block @param {number} x @param {number} y */
function mix(words, [a, b, c, d], block, x, y) {
  add(words, a, words[b], words[b + 1]);
  add(words, a, block[x], block[x + 1]);
  turn(words, d, a, 32);
  add(words, c, words[d], words[d + 1]);
  turn(words, b, c, 24);
  add(words, a, words[b], words[b + 1]);
  add(words, a, block[y], block[y + 1]);
  turn(words, d, a, 16);
  add(words, c, words[d], words[d + 1]);
  turn(words, b, c, 63);
}

/** Takes in a block; `length`: bytes up to its end; `last`: whether none follows. */
function compress(state, block, length, last) {
  const words = new Uint32Array(32);
  words.set(state);
  words.set(INITIAL, 16);
  words[24] ^= length;
  if (last) [words[28], words[29]] = [~words[28], ~words[29]];
  for (const order of ORDER)
    QUARTERS.forEach((quarter, k) => mix(words, quarter, block, order[2 * k], order[2 * k + 1]));
  for (let i = 0; i < 16; i++) state[i] ^= words[i] ^ words[i + 16];
}

/** The digest of up to 4 GiB. @param {Uint8Array} bytes @param {number} [size] of the digest, bytes @returns {Uint8Array} */
export function digest(bytes, size = 8) {
  const state = INITIAL.slice();
  state[0] ^= 0x01010000 ^ size;
  const blocks = Math.max(1, Math.ceil(bytes.length / BLOCK));
  for (let i = 0; i < blocks; i++) {
    const part = bytes.subarray(BLOCK * i, BLOCK * (i + 1)),
      block = new Uint32Array(BLOCK / 4);
    part.forEach((byte, k) => (block[k >> 2] |= byte << (8 * (k & 3))));
    compress(state, block, BLOCK * i + part.length, i === blocks - 1);
  }
  return Uint8Array.from({ length: size }, (_, k) => state[k >> 2] >>> (8 * (k & 3)));
}

const KEY_BYTES = 6; // a number holds so long a whole number exactly

/** A text as a whole number above 0, as `key_of` of `pointpred/targets/rectangles.py`. @param {string} text */
export const keyOf = (text) => numberOf(text) || 1;

/** A text as a whole number. @param {string} text */
export const numberOf = (text) =>
  digest(new TextEncoder().encode(text), KEY_BYTES).reduce((number, byte) => 256 * number + byte, 0);
