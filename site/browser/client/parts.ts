// The parts of a page, each of which starts by itself: where one fails, the browser's console says why,
// and all others are there.

export function startParts(...parts: readonly (() => void)[]): void {
  for (const start of parts) {
    try {
      start();
    } catch (error) {
      reportError(error);
    }
  }
}
