/** Whether a number that a reader gave is right. */

/** Within `tolerance`; decimals are not exact in binary, so a tolerance of 0 still allows for that. */
export function isRight(given: number, right: number, tolerance: number): boolean {
  const allowed = tolerance + 1e-12 * Math.max(1, Math.abs(right));
  return Math.abs(given - right) <= allowed;
}
