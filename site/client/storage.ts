// What a reader's browser remembers of this site. Storage may be refused, as in private windows: then
// nothing is remembered, and the page does as if it were the first visit.

export function recall(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

/** Null forgets. */
export function remember(key: string, value: string | null): void {
  try {
    if (value === null) localStorage.removeItem(key);
    else localStorage.setItem(key, value);
  } catch {
    // The page still shows what was chosen.
  }
}
