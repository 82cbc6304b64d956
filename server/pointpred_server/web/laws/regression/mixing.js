// Written by `make page` from mixing.py: change that and run it again.
export function work(n) {
  return n * n;
}
export function determinant(memory, at, n) {
  let result = 1;
  for (let k = 0; k < n; k++) {
    let pivot = k;
    for (let i = k + 1; i < n; i++) {
      if (Math.abs(memory[at + i * n + k]) > Math.abs(memory[at + pivot * n + k])) {
        pivot = i;
      }
    }
    const value = memory[at + pivot * n + k];
    if (value === 0) {
      return 0;
    }
    if (pivot !== k) {
      result = -result;
      for (let j = k; j < n; j++) {
        const top = at + k * n + j;
        const low = at + pivot * n + j;
        const value_1 = memory[low];
        const value_2 = memory[top];
        memory[top] = value_1;
        memory[low] = value_2;
      }
    }
    result *= value;
    for (let i = k + 1; i < n; i++) {
      const factor = memory[at + i * n + k] / value;
      for (let j = k + 1; j < n; j++) {
        memory[at + i * n + j] -= factor * memory[at + k * n + j];
      }
    }
  }
  return result;
}
export function mix3(memory, a, y, out) {
  const a11 = memory[a];
  const a12 = memory[a + 1];
  const a13 = memory[a + 2];
  const a21 = memory[a + 3];
  const a22 = memory[a + 4];
  const a23 = memory[a + 5];
  const a31 = memory[a + 6];
  const a32 = memory[a + 7];
  const a33 = memory[a + 8];
  const y1 = memory[y];
  const y2 = memory[y + 1];
  const y3 = memory[y + 2];
  const c11 = a22 * a33 - a23 * a32;
  const c12 = a23 * a31 - a21 * a33;
  const c13 = a21 * a32 - a22 * a31;
  const c21 = a13 * a32 - a12 * a33;
  const c22 = a11 * a33 - a13 * a31;
  const c23 = a12 * a31 - a11 * a32;
  const c31 = a12 * a23 - a13 * a22;
  const c32 = a13 * a21 - a11 * a23;
  const c33 = a11 * a22 - a12 * a21;
  memory[out] = c11 * y1 + c21 * y2 + c31 * y3;
  memory[out + 1] = c12 * y1 + c22 * y2 + c32 * y3;
  memory[out + 2] = c13 * y1 + c23 * y2 + c33 * y3;
  return a11 * c11 + a12 * c12 + a13 * c13;
}
export function mix(memory, a, y, n, out, scratch) {
  let phi;
  if (n === 3) {
    return mix3(memory, a, y, out);
  }
  for (let column = -1; column < n; column++) {
    for (let i = 0; i < n; i++) {
      for (let j = 0; j < n; j++) {
        memory[scratch + i * n + j] = j === column ? memory[y + i] : memory[a + i * n + j];
      }
    }
    const value = determinant(memory, scratch, n);
    if (column < 0) {
      phi = value;
    } else {
      memory[out + column] = value;
    }
  }
  return phi;
}
