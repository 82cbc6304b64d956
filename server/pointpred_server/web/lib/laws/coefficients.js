// The coefficients of the learned predictor.

const BYTES = 4;

/**
 * The numbers of a file of coefficients: float32, little-endian, the first bytes of all of them before the second ones, and so
 * on, because the file is smaller so when it is compressed.
 * @param {ArrayBuffer} packed @returns {Float64Array} Throws an Error for anything else, such as a page that says that there is no such file.
 */
export function unpack(packed) {
  const planes = new Uint8Array(packed),
    count = Math.floor(planes.length / BYTES),
    view = new DataView(new ArrayBuffer(planes.length));
  for (let k = 0; k < BYTES; k++) for (let i = 0; i < count; i++) view.setUint8(BYTES * i + k, planes[k * count + i]);
  const numbers = Float64Array.from({ length: count }, (_, i) => view.getFloat32(BYTES * i, true));
  const [first, second] = numbers; // the widths of the hidden layers
  const isFile =
    [planes.length / BYTES, first, second].every(Number.isInteger) && first > 0 && second > 0 && first * second < count;
  if (!isFile)
    throw new Error(
      `not a file of coefficients: ${planes.length} bytes; serve laws/kinematic.f32 as it is in the package`,
    );
  return numbers;
}
