// Whether a number that a reader gave is the right one, in a question and in a lab. The generator
// holds answers against what it finds by the same rule (generator/lesson/json/tolerance.h).

/** Within `tolerance`. Decimals are not exact in binary, and whole numbers are. */
export function isNear(given: number, right: number, tolerance: number): boolean {
  const whole = Number.isSafeInteger(given) && Number.isSafeInteger(right);
  const rounding = whole ? 0 : 1e-12 * Math.max(Math.abs(given), Math.abs(right));
  return Math.abs(given - right) <= tolerance * (1 + 1e-12) + rounding;
}
