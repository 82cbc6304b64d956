// Written by `make laws` from gradient.py: change that and run it again.
export function descend(theta, mixed, phi, gamma, h) {
  const exponent = gamma * phi * phi * h;
  if (exponent <= 0) {
    return theta;
  }
  return theta - Math.expm1(-exponent) / phi * (mixed - phi * theta);
}
